namespace Nowpose.Headless.Tests.Ros;

/// <summary>Thrown if rosbridge writes an error to its log instead of executing a request.</summary>
sealed class RosException(string message) : Exception(message);
