namespace Nowpose.Cli.Demo;

/// <summary>A run ended without a valid result. The message gives the reason.</summary>
sealed class DemoFailedException(string message) : Exception(message);
