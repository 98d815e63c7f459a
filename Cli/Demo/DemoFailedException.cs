namespace Nowpose.Cli.Demo;

/// <summary>A run came to its end and proves nothing; the message says why.</summary>
sealed class DemoFailedException(string message) : Exception(message);
