"""What results show of themselves: the contract, and a picture in memory."""
