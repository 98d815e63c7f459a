namespace Nowpose.Vision;

/// <summary>Thrown if a worker process exits unexpectedly.</summary>
sealed class WorkerEndedException(string message) : InvalidOperationException(message);
