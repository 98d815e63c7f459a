namespace Nowpose.Vision;

/// <summary>
/// Idle workers of earlier pools, kept for reuse. Loading OpenCV and compiling its hot functions takes as long as reading three pictures, so a
/// process with several pools, such as <c>figures</c>, reuses them. Thread-safe.
/// </summary>
/// <remarks>Static, because the workers outlive each pool. A worker exits when its input ends, so none outlives this process.</remarks>
static class KeptWorkers
{
    /// <summary>Maximum number of kept workers.</summary>
    public const int Max = 4;

    static readonly Stack<VisionWorker> Idle = [];

    /// <returns>A running worker without a pending request, or null if there is none.</returns>
    public static VisionWorker Take()
    {
        lock (Idle)
        {
            while (Idle.TryPop(out var worker))
            {
                if (worker.IsIdle) return worker;
                worker.Dispose();
            }
        }
        return null;
    }

    /// <summary>Keeps a worker for reuse. Ends it if it cannot be reused or if <see cref="Max"/> workers are already kept.</summary>
    /// <param name="worker">The worker; null is ignored.</param>
    public static void Keep(VisionWorker worker)
    {
        if (worker == null) return;
        lock (Idle)
        {
            if (worker.IsIdle && Idle.Count < Max)
            {
                Idle.Push(worker);
                return;
            }
        }
        worker.Dispose();
    }
}
