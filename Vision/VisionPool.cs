using System.Collections.Concurrent;
using System.Runtime.ExceptionServices;
using System.Text.Json;
using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>Analyses many pictures in parallel worker processes.</summary>
/// <remarks>
/// If a picture makes a worker exit, for example because of insufficient memory, the picture is reported as faulty, and another worker
/// continues. The workers of a pool are kept for the next pool of this process.
/// </remarks>
public sealed class VisionPool : IDisposable
{
    const int MaxWorkers = 4;
    const int Waiting = 4;

    /// <summary>
    /// Number of pictures for which another worker is started. Starting a worker and compiling its code takes as long as reading a few pictures.
    /// </summary>
    const int PicturesPerWorker = 12;

    /// <summary>
    /// If workers exit on this number of consecutive pictures, the pictures are assumed not to be the cause, and the analysis fails.
    /// </summary>
    const int MaxEnded = 3;

    readonly string _script;
    readonly int _picturesPerWorker;
    readonly VisionWorker[] _workers;

    /// <param name="workers">Maximum number of workers; 0 for one per core, but at most four.</param>
    /// <exception cref="InputException">Node.js is not installed, or was not installed when this program was built.</exception>
    public VisionPool(int workers = 0) : this(workers, null)
    {
    }

    /// <param name="script">Script that the workers run; null for the script of this program. Workers with another script are not reused.</param>
    /// <param name="picturesPerWorker">Number of pictures for which another worker is started.</param>
    internal VisionPool(int workers, string script, int picturesPerWorker = PicturesPerWorker)
    {
        _script = script;
        _picturesPerWorker = picturesPerWorker;
        _workers = new VisionWorker[workers > 0 ? workers : Math.Clamp(Environment.ProcessorCount, 1, MaxWorkers)];
        // Starts the first worker now, so that a missing Node.js is reported immediately. The others start with their first picture.
        _workers[0] = StartedOrKept();
    }

    /// <summary>Number of workers that have been started or taken over from an earlier pool.</summary>
    internal int WorkerCount => _workers.Count(worker => worker != null);

    /// <summary>Analyses all pictures. Returns early when it is cancelled, and then throws no errors.</summary>
    /// <param name="pictures">The pictures. They are enumerated on demand on the calling thread.</param>
    /// <param name="seen">Called with the index and the result of each picture, in any order but never concurrently.</param>
    internal void Look(IEnumerable<PictureRequest> pictures, Action<int, SeenPicture> seen, CancellationToken cancellation)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        using var queue = new BlockingCollection<(int Place, PictureRequest Picture)>(Waiting * _workers.Length);
        var faults = new ConcurrentQueue<Exception>();
        var gate = new object();
        void Guard(Action action)
        {
            try
            {
                action();
            }
            catch (OperationCanceledException)
            {
                // The user cancelled the analysis, or another thread failed.
            }
            catch (Exception fault)
            {
                faults.Enqueue(fault);
                stop.Cancel();
            }
        }

        var workers = new List<Task>();
        Task Start(int worker) => Task.Factory.StartNew(
            () => Guard(() => Work(worker, queue.GetConsumingEnumerable(stop.Token), (place, picture) => { lock (gate) seen(place, picture); })),
            CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        Guard(() =>
        {
            var place = 0;
            foreach (var picture in pictures)
            {
                if (place == _picturesPerWorker * workers.Count && workers.Count < _workers.Length) workers.Add(Start(workers.Count));
                queue.Add((place++, picture), stop.Token);
            }
        });
        queue.CompleteAdding();
        Task.WaitAll([.. workers], CancellationToken.None);
        if (!cancellation.IsCancellationRequested && !faults.IsEmpty)
            ExceptionDispatchInfo.Throw(faults.OfType<InputException>().FirstOrDefault() ?? faults.First());
    }

    void Work(int worker, IEnumerable<(int Place, PictureRequest Picture)> queue, Action<int, SeenPicture> seen)
    {
        var ended = 0;
        foreach (var (place, picture) in queue) seen(place, Ask(worker, picture, ref ended));
    }

    VisionWorker StartedOrKept() => (_script == null ? KeptWorkers.Take() : null) ?? new VisionWorker(_script);

    SeenPicture Ask(int worker, PictureRequest picture, ref int ended)
    {
        var asked = _workers[worker] ??= StartedOrKept();
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
            return SeenPicture.Not(PictureReaderMessages.Stopped);
        }
    }

    static SeenPicture SeenOf(JsonElement answer)
    {
        if (answer.TryGetProperty("error", out var error)) return SeenPicture.Not(error.GetString().ReplaceLineEndings(" "));
        if (!answer.TryGetProperty("codes", out var codes)) return new SeenPicture(0, 0, [], null);
        return new SeenPicture(answer.GetProperty("width").GetInt32(), answer.GetProperty("height").GetInt32(), [.. codes.EnumerateArray().Select(CodeOf)], null)
        {
            IsMirrored = answer.GetProperty("isMirrored").GetBoolean(),
        };
    }

    static FoundCode CodeOf(JsonElement code) => new(
        Enum.Parse<CodeKind>(code.GetProperty("kind").GetString()),
        [.. code.GetProperty("levels").EnumerateArray().Select(level => level.GetDouble())],
        [.. code.GetProperty("corners").EnumerateArray().Select(corner => (corner[0].GetDouble(), corner[1].GetDouble()))])
    {
        WhiteShare = code.GetProperty("white").GetDouble(),
        Residual = code.GetProperty("residual").GetDouble(),
        IsWeak = code.GetProperty("isWeak").GetBoolean(),
    };

    public void Dispose()
    {
        foreach (var worker in _workers)
            if (_script == null) KeptWorkers.Keep(worker);
            else worker?.Dispose();
    }
}
