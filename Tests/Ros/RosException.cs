namespace Nowpose.Headless.Tests.Ros;

/// <summary>What rosbridge writes into its log instead of doing what it was asked.</summary>
sealed class RosException(string message) : Exception(message);
