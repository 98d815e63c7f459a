using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Tests the pool with a substitute for the picture reader that exits when it receives a picture with a certain name.</summary>
[NonParallelizable]
public sealed class VisionPoolTests
{
    const string StandIn = """
        import { createInterface } from 'node:readline';
        for await (const line of createInterface({ input: process.stdin })) {
          if (line.includes('deadly')) process.exit(9);
          process.stdout.write('{"width":4,"height":3,"codes":[],"isMirrored":false}\n');
        }
        """;

    string _script;

    [OneTimeSetUp]
    public void WriteStandIn()
    {
        Needs.Vision();
        _script = Path.Combine(Path.GetTempPath(), $"nowpose-{Guid.NewGuid():N}.mjs");
        File.WriteAllText(_script, StandIn);
    }

    [OneTimeTearDown]
    public void RemoveStandIn()
    {
        if (_script != null) File.Delete(_script);
    }

    SortedDictionary<int, SeenPicture> Look(IEnumerable<PictureRequest> pictures, CancellationToken cancellation = default)
    {
        var all = new SortedDictionary<int, SeenPicture>();
        using var pool = new VisionPool(1, _script);
        pool.Look(pictures, (place, seen) => all[place] = seen, cancellation);
        return all;
    }

    static IEnumerable<PictureRequest> Files(params string[] names) => names.Select(PictureRequest.File);

    [Test]
    public void Look_PictureCrashesAWorker_RejectsOnlyThatPicture()
    {
        var seen = Look(Files("a.png", "deadly.png", "b.png", "deadly.png", "deadly.png", "c.png"));

        Assert.That(seen.Values.Select(picture => picture.Fault == null), Is.EqualTo(new[] { true, false, true, false, false, true }));
        Assert.That(seen[1].Fault, Is.EqualTo(PictureReaderMessages.Stopped));
    }

    [Test]
    public void Look_WorkerExitsAtStart_ThrowsWithItsOutput()
    {
        var script = Path.ChangeExtension(_script, ".once.mjs");
        File.WriteAllText(script, "console.error('no memory'); process.exit(7);");
        try
        {
            Assert.That(() => new VisionPool(1, script).Dispose(), Throws.InstanceOf<InvalidOperationException>().With.Message.Contains("no memory"));
            File.WriteAllText(script, StandIn);
            using var pool = new VisionPool(2, script);
            File.WriteAllText(script, "console.error('no memory'); process.exit(7);");
            Assert.That(
                () => pool.Look(WithoutEnd(), (_, _) => { }, default), Throws.InstanceOf<InvalidOperationException>().With.Message.Contains("no memory"));
        }
        finally
        {
            File.Delete(script);
        }
    }

    // Never ends, so the second worker also receives a picture, regardless of when it is ready.
    static IEnumerable<PictureRequest> WithoutEnd()
    {
        while (true) yield return PictureRequest.File("a.png");
    }

    [Test]
    public void Look_WorkerExitsAtEveryPicture_Throws()
    {
        Assert.That(() => Look(Files("deadly1.png", "deadly2.png", "deadly3.png", "deadly4.png")), Throws.InstanceOf<InvalidOperationException>());
    }

    [Test]
    public void Look_FaultAfterCancellation_ReturnsThePicturesReadSoFar()
    {
        using var cancellation = new CancellationTokenSource();
        IEnumerable<PictureRequest> Interrupted()
        {
            yield return PictureRequest.File("a.png");
            cancellation.Cancel();
            throw new InputException("the video ended early");
        }

        Assert.That(() => Look(Interrupted(), cancellation.Token), Throws.Nothing);
    }

    [Test]
    public void Keep_IdleWorker_IsTakenByTheNextPool()
    {
        RemoveKept();
        var worker = new VisionWorker(_script);

        KeptWorkers.Keep(worker);

        using var taken = KeptWorkers.Take();
        Assert.That(taken, Is.SameAs(worker));
        Assert.That(KeptWorkers.Take(), Is.Null, "no second worker is kept");
        Assert.That(taken.Ask(PictureRequest.File("a.png").Json()).GetProperty("width").GetInt32(), Is.EqualTo(4));
    }

    [Test]
    public void Keep_WorkerThatExited_IsNotTaken()
    {
        RemoveKept();
        var worker = new VisionWorker(_script);
        Assert.That(() => worker.Ask(PictureRequest.File("deadly.png").Json()), Throws.InstanceOf<WorkerEndedException>());

        KeptWorkers.Keep(worker);

        Assert.That(KeptWorkers.Take(), Is.Null);
    }

    [Test]
    public void Keep_MoreWorkersThanAreKept_EndsTheOthers()
    {
        RemoveKept();
        var workers = Enumerable.Range(0, KeptWorkers.Max + 1).Select(_ => new VisionWorker(_script)).ToArray();

        foreach (var worker in workers) KeptWorkers.Keep(worker);

        Assert.That(RemoveKept(), Is.EqualTo(workers[..KeptWorkers.Max].Reverse()));
    }

    // Takes all kept workers. Other test fixtures in this process also keep workers, but they do not run at the same time.
    static List<VisionWorker> RemoveKept()
    {
        var kept = new List<VisionWorker>();
        while (KeptWorkers.Take() is { } worker)
        {
            kept.Add(worker);
            worker.Dispose();
        }
        return kept;
    }
}
