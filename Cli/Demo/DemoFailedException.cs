namespace Nowpose.Cli.Demo;

/// <summary>Thrown if a run ends without a valid result. The message gives the reason.</summary>
sealed class DemoFailedException(string message) : Exception(message);
