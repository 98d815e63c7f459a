using NUnit.Framework;

namespace Nowpose.Headless.Tests.ControlSystem;

/// <summary>Runs the belt's program on the manual's page about objects of a PLC program.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class BeltProgramTests
{
    const int ValuesPerWorkpiece = 7;
    const decimal Store = 0, Conveyor = 1, Gripper = 2, Fixture = 3;

    const string CycleTime = "TwinCAT_SystemInfoVarList._TaskInfo[GETCURTASKINDEXEX()].CycleTime";

    /// <summary>Interval of the task in units of 100 ns, as in TwinCAT.</summary>
    ulong _cycleTime = 10_000;
    readonly StructuredText _program;

    public BeltProgramTests() => _program = new(Source(), new() { [CycleTime] = () => _cycleTime });

    /// <summary>Gets the program as the PLC compiles it, from the blocks of the page for the declaration, the lists and the implementation.</summary>
    static string Source()
    {
        var page = File.ReadAllText(Path.Combine(RepositoryFiles.Root, RepositoryFiles.Package, "Documentation~", "objects-from-a-plc.md"));
        var blocks = page.Split("```").Select(block => block.Trim()).ToArray();
        string[] Starting(string text) => [.. blocks.Where(block => block.StartsWith(text, StringComparison.Ordinal))];
        return string.Join('\n', [.. Starting("PROGRAM PRG_Belt"), .. Starting("VAR_GLOBAL"), .. Starting("fCycleTime :="), "END_PROGRAM"]);
    }

    decimal X(int workpiece) => _program.Array("GVL.aWorkpiece")[ValuesPerWorkpiece * workpiece];

    decimal Parent(int workpiece) => _program.Array("GVL.aWorkpiece")[ValuesPerWorkpiece * workpiece + 6];

    decimal[] Parents => [Parent(0), Parent(1), Parent(2)];

    void Run(int cycles, bool isInterrupted = false)
    {
        _program["GVL.bLightBarrier"] = isInterrupted ? 1 : 0;
        for (var i = 0; i < cycles; i++) _program.Run();
    }

    [Test]
    public void Run_LightBarrierFree_AllWorkpiecesAreInTheStore()
    {
        _program["GVL.fBeltSpeed"] = 150;

        Run(10);

        Assert.That(Parents, Is.All.EqualTo(Store));
        Assert.That(X(0), Is.Zero);
    }

    [Test]
    public void Run_WorkpieceInTheLightBarrier_MovesWithTheMeasuredSpeed()
    {
        _program["GVL.fBeltSpeed"] = 150;

        Run(1, isInterrupted: true);
        Run(200, isInterrupted: true);
        _program["GVL.fBeltSpeed"] = 0;
        Run(100);
        _program["GVL.fBeltSpeed"] = 50.5m;
        Run(1000);

        Assert.That(Parents, Is.EqualTo(new[] { Conveyor, Store, Store }), "one workpiece per interruption of the light barrier");
        Assert.That(X(0), Is.EqualTo(0.2m * 150 + 50.5m), "mm");
        Assert.That(_program.Array("GVL.aWorkpiece")[2], Is.EqualTo(15), "height of the centre");
    }

    [TestCase(10_000UL)]
    [TestCase(100_000UL)]
    [TestCase(20_000UL)]
    public void Run_IntervalOfTheTask_WorkpieceMovesWithTheBelt(ulong cycleTime)
    {
        _cycleTime = cycleTime;
        _program["GVL.fBeltSpeed"] = 150;
        Run(1, isInterrupted: true);

        Run((int)(10_000_000 / cycleTime));

        Assert.That(X(0), Is.EqualTo(150), "mm after one second");
    }

    [Test]
    public void Run_WorkpieceAtTheEnd_LeavesAndTheOthersKeepTheirElements()
    {
        _program["GVL.fBeltSpeed"] = 1000;
        Run(1, isInterrupted: true);
        Run(599);
        Run(1, isInterrupted: true);

        Run(599);
        Assert.That((X(0), X(1)), Is.EqualTo((1199m, 599m)));
        Run(1);

        Assert.That(Parents, Is.EqualTo(new[] { Store, Conveyor, Store }));
        Assert.That(X(1), Is.EqualTo(600));
        Run(1, isInterrupted: true);
        Assert.That(Parents, Is.EqualTo(new[] { Conveyor, Conveyor, Store }), "a new workpiece uses the free elements");
        Assert.That(X(0), Is.Zero);
    }

    [Test]
    public void Run_GripperCloses_WritesTheParentAndThePoseInItInTheSameCycle()
    {
        RunToThePickPosition();
        var onTheBelt = ValuesOf(0);

        _program["GVL.bGripperClosed"] = 1;
        Run(1);

        Assert.That(onTheBelt, Is.EqualTo(new decimal[] { 900, 0, 15, 0, 0, 0, Conveyor }));
        Assert.That(ValuesOf(0), Is.EqualTo(new decimal[] { 0, 0, 150, 0, 0, 180, Gripper }));
    }

    [Test]
    public void Run_GrippedWorkpiece_KeepsItsPoseInTheGripper()
    {
        RunToThePickPosition();
        _program["GVL.bGripperClosed"] = 1;
        Run(1);
        var gripped = ValuesOf(0);

        Run(500);
        Run(500, isInterrupted: true);

        Assert.That(ValuesOf(0), Is.EqualTo(gripped));
        Assert.That(Parents, Is.EqualTo(new[] { Gripper, Conveyor, Store }), "the next workpiece uses other elements");
    }

    [Test]
    public void Run_GripperOpens_WorkpieceIsOnTheFixtureUntilItIsUnloaded()
    {
        RunToThePickPosition();
        _program["GVL.bGripperClosed"] = 1;
        Run(100);

        _program["GVL.bGripperClosed"] = 0;
        Run(1);
        var released = ValuesOf(0);
        Run(10);
        _program["GVL.bFixtureOccupied"] = 1;
        Run(10);
        var resting = ValuesOf(0);
        _program["GVL.bFixtureOccupied"] = 0;
        Run(1);

        Assert.That(released, Is.EqualTo(new decimal[] { 0, 0, 15, 0, 0, 0, Fixture }));
        Assert.That(resting, Is.EqualTo(released), "also while the sensor of the fixture is late");
        Assert.That(Parents, Is.All.EqualTo(Store));
    }

    [TestCase(860)]
    [TestCase(940)]
    public void Run_GripperClosesBesideTheWorkpiece_WorkpieceStaysOnTheBelt(int x)
    {
        RunToThePickPosition(x);

        _program["GVL.bGripperClosed"] = 1;
        Run(100);
        _program["GVL.bGripperClosed"] = 0;
        Run(1);

        Assert.That((X(0), Parent(0)), Is.EqualTo(((decimal)x, Conveyor)));
    }

    [Test]
    public void Run_GripperIsClosedBeforeTheWorkpieceArrives_WorkpieceStaysOnTheBelt()
    {
        _program["GVL.bGripperClosed"] = 1;

        RunToThePickPosition();

        Assert.That(Parents, Is.EqualTo(new[] { Conveyor, Store, Store }));
    }

    [Test]
    public void Run_TwoWorkpiecesWithinReach_GripperTakesOne()
    {
        _program["GVL.fBeltSpeed"] = 1000;
        Run(1, isInterrupted: true);
        Run(9);
        Run(1, isInterrupted: true);
        Run(899);
        _program["GVL.fBeltSpeed"] = 0;

        _program["GVL.bGripperClosed"] = 1;
        Run(2);

        Assert.That(Parents, Is.EqualTo(new[] { Gripper, Conveyor, Store }));
    }

    // The belt stops when the centre of the first workpiece is at this position, in mm.
    void RunToThePickPosition(int x = 900)
    {
        _program["GVL.fBeltSpeed"] = 1000;
        Run(1, isInterrupted: true);
        Run(x);
        _program["GVL.fBeltSpeed"] = 0;
    }

    decimal[] ValuesOf(int workpiece) => _program.Array("GVL.aWorkpiece")[(ValuesPerWorkpiece * workpiece)..(ValuesPerWorkpiece * (workpiece + 1))];
}
