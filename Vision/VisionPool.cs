using System.Collections.Concurrent;
using System.Text.Json;
using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>Analyses many pictures, as many in parallel as there are cores.</summary>
/// <remarks>
/// A picture at which a worker ends, for example because of too little memory, is reported as faulty, and another worker continues. Each
/// worker stores the last position of the codes. The assignment of pictures to workers depends on their number alone, so results are
/// reproducible.
/// </remarks>
public sealed class VisionPool : IDisposable
{
    const int MaxWorkers = 4;
    const int Waiting = 4;

    /// <summary>Number of consecutive pictures that end a worker after which the cause is assumed not to be the pictures.</summary>
    const int MaxEnded = 3;

    readonly string _script;
    readonly VisionWorker[] _workers;

    /// <param name="workers">Number of workers; 0 for the number of cores, at most four.</param>
    /// <exception cref="InputException">Node.js is missing, or was missing when this program was built.</exception>
    public VisionPool(int workers = 0) : this(workers, null)
    {
    }

    /// <param name="script">Script of a worker; null for the one included in this program.</param>
    internal VisionPool(int workers, string script)
    {
        _script = script;
        _workers = new VisionWorker[workers > 0 ? workers : Math.Clamp(Environment.ProcessorCount, 1, MaxWorkers)];
        // Started now, so that a missing Node.js is reported at once. The others start in parallel, each with its first picture.
        _workers[0] = new VisionWorker(script);
    }

    /// <summary>Analyses all pictures, or runs until it is cancelled. Errors after the cancellation are ignored.</summary>
    /// <param name="pictures">Enumerated on demand, on a separate thread.</param>
    /// <param name="seen">Receives each picture's index and its result; one call at a time, in any order.</param>
    internal void Look(IEnumerable<PictureRequest> pictures, Action<int, SeenPicture> seen, CancellationToken cancellation)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        var queues = _workers.Select(_ => new BlockingCollection<(int, PictureRequest)>(Waiting)).ToArray();
        var gate = new object();
        Task[] tasks =
        [
            Task.Run(() => Feed(pictures, queues, stop), CancellationToken.None),
            .. _workers.Select((_, i) => Task.Factory.StartNew(
                () => Work(i, queues[i], (place, picture) => { lock (gate) seen(place, picture); }, stop),
                CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default)),
        ];
        try
        {
            Task.WaitAll(tasks, CancellationToken.None);
        }
        catch (AggregateException faults)
        {
            if (cancellation.IsCancellationRequested) return;
            var faultsProper = faults.Flatten().InnerExceptions.Where(fault => fault is not OperationCanceledException).ToList();
            if (faultsProper.Count > 0) throw faultsProper.OfType<InputException>().FirstOrDefault() ?? faultsProper[0];
        }
    }

    static void Feed(IEnumerable<PictureRequest> pictures, BlockingCollection<(int, PictureRequest)>[] queues, CancellationTokenSource stop)
    {
        try
        {
            var place = 0;
            foreach (var picture in pictures)
            {
                queues[place % queues.Length].Add((place, picture), stop.Token);
                place++;
            }
        }
        catch (Exception e) when (e is not OperationCanceledException)
        {
            stop.Cancel();
            throw;
        }
        finally
        {
            foreach (var queue in queues) queue.CompleteAdding();
        }
    }

    void Work(int worker, BlockingCollection<(int, PictureRequest)> queue, Action<int, SeenPicture> seen, CancellationTokenSource stop)
    {
        try
        {
            var ended = 0;
            foreach (var (place, picture) in queue.GetConsumingEnumerable(stop.Token)) seen(place, Ask(worker, picture, ref ended));
        }
        catch (Exception e) when (e is not OperationCanceledException)
        {
            stop.Cancel();
            throw;
        }
    }

    SeenPicture Ask(int worker, PictureRequest picture, ref int ended)
    {
        var asked = _workers[worker] ??= new VisionWorker(_script);
        try
        {
            var seen = SeenOf(asked.Ask(picture.Json()));
            ended = 0;
            return seen;
        }
        catch (WorkerEndedException) when (++ended < MaxEnded)
        {
            asked.Dispose();
            _workers[worker] = null;
            return new SeenPicture(0, 0, [], "what reads pictures has ended at it; is it too large?");
        }
    }

    static SeenPicture SeenOf(JsonElement answer)
    {
        if (answer.TryGetProperty("error", out var error)) return new SeenPicture(0, 0, [], error.GetString().ReplaceLineEndings(" "));
        if (!answer.TryGetProperty("codes", out var codes)) return new SeenPicture(0, 0, [], null);
        return new SeenPicture(answer.GetProperty("width").GetInt32(), answer.GetProperty("height").GetInt32(), [.. codes.EnumerateArray().Select(CodeOf)], null);
    }

    static FoundCode CodeOf(JsonElement code) => new(
        Enum.Parse<CodeKind>(code.GetProperty("kind").GetString()),
        [.. code.GetProperty("levels").EnumerateArray().Select(level => level.GetDouble())],
        [.. code.GetProperty("corners").EnumerateArray().Select(corner => (corner[0].GetDouble(), corner[1].GetDouble()))]);

    public void Dispose()
    {
        foreach (var worker in _workers) worker?.Dispose();
    }
}
