namespace Nowpose.Vision;

/// <summary>The process that analyses pictures has ended unexpectedly.</summary>
sealed class WorkerEndedException(string message) : InvalidOperationException(message);
