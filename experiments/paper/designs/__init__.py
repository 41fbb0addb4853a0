"""One robot to many targets, and many robots to theirs."""
