using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>A cell board in virtual time, and poses for it.</summary>
public abstract class CellBoardFixture
{
    private protected readonly SteppedTime _time = new();
    private protected CellReports _reports;
    private protected CellBoard _board;
    private protected HubSource _source;

    [SetUp]
    public void Start()
    {
        _reports = new CellReports(_time);
        _board = new CellBoard(_time, _reports, link => link is "tool0" or "base" ? "base" : null, link => link == "tool0" ? ["elbow"] : []);
        _source = new MessageHub().OpenSource();
    }

    private protected static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);

    private protected static TransformsMessage Pose(string child, double t, string parent = "world") => new(new FrameTransform(At(t), parent, child, 1, 2, 3, 0, 0, 0, 1));
}
