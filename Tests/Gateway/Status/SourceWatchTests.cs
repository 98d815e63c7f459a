using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway.Status;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class SourceWatchTests
{
    static long At(double seconds) => (long)(1_000_000 + seconds * Stopwatch.Frequency);

    [Test]
    public void Read_SteadySource_ReturnsRateAndAges()
    {
        var watch = new SourceWatch();
        for (var i = 0; i <= 100; i++) watch.Add(["a", "b"], At(i * 0.02), TimeSpan.FromMilliseconds(i));

        var (names, rate, ages) = watch.Read(At(2)).Single();

        Assert.That(names, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(rate, Is.EqualTo(50).Within(0.5));
        Assert.That(ages, Is.Ordered.And.Length.EqualTo(101));
    }

    [Test]
    public void Read_SourceStops_ReturnsADecreasingRateAndThenNoSource()
    {
        var watch = new SourceWatch();
        for (var i = 0; i <= 100; i++) watch.Add(["a"], At(i * 0.02), TimeSpan.Zero);

        Assert.That(watch.Read(At(4)).Single().RateHz, Is.EqualTo(25).Within(0.5));
        Assert.That(watch.Read(At(8)).Single().RateHz, Is.EqualTo(0));
        Assert.That(watch.Read(At(13)), Is.Empty);
    }

    [Test]
    public void Add_ArmAndGripperInSeparateMessages_CountsTwoSources()
    {
        var watch = new SourceWatch();
        foreach (var names in new[] { "arm", "gripper", "arm" }) watch.Add([names], At(0), TimeSpan.Zero);

        Assert.That(watch.Read(At(0)).Select(source => source.Names.Single()), Is.EquivalentTo(new[] { "arm", "gripper" }));
    }

    [Test]
    public void Add_MessagesWithOverlappingJoints_CountsOneSource()
    {
        var watch = new SourceWatch();
        string[] joints = ["a", "b", "c", "d", "e"];
        var random = new Random(7);
        for (var i = 0; i < 5 * 47; i++)
        {
            var moved = joints.Where(_ => random.Next(2) == 0).DefaultIfEmpty("a").ToArray();
            watch.Add(moved, At(i / 47.0), TimeSpan.FromMilliseconds(i % 10));
        }

        var (names, rate, ages) = watch.Read(At(5)).Single();

        Assert.That(names, Is.EquivalentTo(joints));
        Assert.That(rate, Is.EqualTo(47).Within(0.5));
        Assert.That(ages, Is.Ordered.And.Length.GreaterThan(5 * 46));
    }

    [Test]
    public void Add_MessageThatMergesTwoSources_KeepsTheirCounts()
    {
        var watch = new SourceWatch();
        for (var i = 0; i < 100; i++) watch.Add([i % 2 == 0 ? "a" : "b"], At(i * 0.02), TimeSpan.FromMilliseconds(i));
        Assert.That(watch.Read(At(2)), Has.Count.EqualTo(2));

        watch.Add(["c", "b", "a"], At(2), TimeSpan.FromMilliseconds(100));

        var (names, rate, ages) = watch.Read(At(2)).Single();
        Assert.That(names, Is.EquivalentTo(new[] { "a", "b", "c" }));
        Assert.That(rate, Is.EqualTo(50).Within(0.5));
        Assert.That(ages, Is.Ordered.And.Length.EqualTo(101));
    }

    [Test]
    public void Add_OneSourceWithManyNewNames_StaysBounded()
    {
        var watch = new SourceWatch();
        for (var i = 0; i < 10_000; i++) watch.Add(["a", $"joint {i}"], At(i * 1e-4), TimeSpan.Zero);

        Assert.That(watch.Read(At(1)).Single().Names, Has.Length.EqualTo(SourceWatch.MaxJoints));

        watch.Add(["late"], At(20), TimeSpan.Zero);
        Assert.That(watch.Read(At(20)).Single().Names, Is.EqualTo(new[] { "late" }), "the source is reported after the other sources have been removed");
    }

    [Test]
    public void Add_ManyNewNames_StaysBoundedAndAcceptsSourcesAfterRemoval()
    {
        var watch = new SourceWatch();
        for (var i = 0; i < 10_000; i++) watch.Add([$"joint {i}"], At(i * 1e-5), TimeSpan.Zero);

        Assert.That(watch.Read(At(0.1)), Has.Count.EqualTo(SourceWatch.MaxSources));

        watch.Add(["late"], At(20), TimeSpan.Zero);
        Assert.That(watch.Read(At(20)).Single().Names, Is.EqualTo(new[] { "late" }));
    }
}
