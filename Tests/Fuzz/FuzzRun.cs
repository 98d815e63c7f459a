using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Feeds seeded inputs to a reader on all cores. The reader must not throw, hang or leak memory.</summary>
sealed class FuzzRun
{
    const long MaxGrowthBytes = 4 * 1024 * 1024;

    /// <summary>Timeout of one input. A reader needs only milliseconds, but the machine can be busy.</summary>
    static readonly TimeSpan InputTimeout = TimeSpan.FromSeconds(15);

    readonly string _name;
    readonly int _seed;
    readonly int _inputs;
    readonly long[] _doing = new long[Environment.ProcessorCount];
    readonly long[] _since = new long[Environment.ProcessorCount];
    long _accepted;
    volatile string _failure;

    /// <param name="inputs">Number of inputs.</param>
    public FuzzRun(string name, int seed, int inputs)
    {
        _name = name;
        _seed = seed;
        _inputs = inputs;
    }

    /// <param name="newReader">Creates a reader for each thread. The reader reads an input and returns whether it accepted the input.</param>
    /// <returns>Number of accepted inputs.</returns>
    public long Feed<T>(Func<Func<Random, T>> newMaker, Func<Func<T, bool>> newReader)
    {
        var watch = Stopwatch.StartNew();
        // Warms up with a tenth of the inputs, so that objects that are kept permanently, such as compiled expressions, exist before the measurement.
        var warm = _inputs / 10;
        FeedPart(newMaker, newReader, 0, warm);
        var before = GC.GetTotalMemory(forceFullCollection: true);
        FeedPart(newMaker, newReader, warm, _inputs);
        var growth = GC.GetTotalMemory(forceFullCollection: true) - before;
        TestContext.Out.WriteLine(
            $"{_name}: {_inputs} inputs, {_accepted} accepted, {watch.Elapsed.TotalSeconds:F1} s, heap {growth / 1024} KiB more, seed {_seed}");
        Assert.That(growth, Is.LessThan(MaxGrowthBytes), $"{_name}: bytes not freed, seed {_seed}");
        return _accepted;
    }

    void FeedPart<T>(Func<Func<Random, T>> newMaker, Func<Func<T, bool>> newReader, int first, int end)
    {
        var threads = Enumerable.Range(0, _doing.Length).Select(part => new Thread(() => FeedEvery(newMaker(), newReader(), part, first, end))
        { IsBackground = true, Name = "fuzz" }).ToList();
        foreach (var thread in threads) thread.Start();
        foreach (var thread in threads)
            while (!thread.Join(TimeSpan.FromSeconds(1)) && _failure == null) LookForHangs();
        Assert.That(_failure, Is.Null);
    }

    void FeedEvery<T>(Func<Random, T> make, Func<T, bool> read, int part, int first, int end)
    {
        for (var i = first + part; i < end && _failure == null; i += _doing.Length)
        {
            Volatile.Write(ref _doing[part], i);
            Volatile.Write(ref _since[part], Stopwatch.GetTimestamp());
            var input = default(T);
            try
            {
                // Each input has its own seed, so that a failing input can be repeated without the previous ones.
                input = make(new Random(HashCode(i)));
                if (read(input)) Interlocked.Increment(ref _accepted);
            }
            catch (Exception e)
            {
                _failure ??= $"{_name}, seed {_seed}, input {i}: {Show(input)}\n{e}";
            }
        }
        Volatile.Write(ref _since[part], long.MaxValue);
    }

    void LookForHangs()
    {
        for (var part = 0; part < _since.Length; part++)
        {
            var since = Volatile.Read(ref _since[part]);
            if (since != long.MaxValue && since != 0 && Stopwatch.GetElapsedTime(since) > InputTimeout)
                _failure ??= $"{_name}, seed {_seed}, input {Volatile.Read(ref _doing[part])}: still being read after {InputTimeout.TotalSeconds} s";
        }
    }

    // Does not use System.HashCode, whose values differ between processes.
    int HashCode(int index) => unchecked((int)((uint)_seed * 2654435761u ^ (uint)index * 2246822519u));

    static string Show<T>(T input)
    {
        var text = input switch
        {
            byte[] bytes => Convert.ToHexString(bytes),
            null => "(not made)",
            _ => input.ToString(),
        };
        return text.Length > 2000 ? text[..2000] + "…" : text;
    }
}
