namespace Nowpose.Vision;

/// <summary>The process that looks at pictures has ended by itself.</summary>
sealed class WorkerEndedException(string message) : InvalidOperationException(message);
