using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Session;

public sealed class SessionReprojectionTests
{
    PlayedCell _cell;

    [SetUp]
    public void SetUp() => _cell = new PlayedCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    [Test]
    public void Reprojection_SessionRestarted_IsKept()
    {
        var session = _cell.Play();
        session.Reprojection = ReprojectionMode.Depth;
        _cell.Run(0.1, session);
        var first = session.Session;

        session.Settings = new(
            new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(40), new PredictionSettings());
        _cell.Run(0.1, session);

        Assert.That(first.Reprojection, Is.EqualTo(ReprojectionMode.Depth));
        Assert.That(session.Session, Is.Not.SameAs(first));
        Assert.That(session.Statistics.Reprojection, Is.EqualTo(ReprojectionMode.Depth));
    }
}
