namespace Nowpose.Headless.Tests.Ros;

/// <summary>A message that rosbridge writes to its log instead of executing a request.</summary>
sealed class RosException(string message) : Exception(message);
