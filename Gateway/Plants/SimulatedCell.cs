using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Gateway.Plants;

/// <summary>A robot cell that publishes its joint positions, objects and signals, with access to the robots' true positions.</summary>
public sealed class SimulatedCell : IDisposable
{
    readonly IControlClock _clock;
    readonly SampleSchedule _schedule;
    readonly string[] _names;
    readonly ManualResetEventSlim _stop = new();
    readonly SetPointsAhead _setPoints;
    readonly CellWork _work;
    readonly string[] _robots;
    Thread _thread;
    long _samples;

    /// <param name="timing">When samples are taken and sent.</param>
    /// <param name="seed">Seed of the acquisition delays.</param>
    /// <param name="publishesPlan">Whether the set-points of the next second are published, too, four times a second.</param>
    public SimulatedCell(IMotion motion, IControlClock clock, CellTiming timing, int seed, bool publishesPlan = false)
        : this(motion, clock, timing, seed, publishesPlan, null)
    {
    }

    /// <param name="work">The work of the robots, whose objects and signals are published, too; null for one robot without work.</param>
    internal SimulatedCell(IMotion motion, IControlClock clock, CellTiming timing, int seed, bool publishesPlan, CellWork work)
    {
        _work = work;
        _robots = work == null ? [""] : [.. work.Robots.Select(robot => robot.Namespace)];
        Motion = motion;
        _clock = clock;
        _names = [.. motion.JointNames];
        Start = clock.Now;
        _setPoints = publishesPlan ? new SetPointsAhead(motion) : null;
        _schedule = new SampleSchedule(Start, timing, seed);
    }

    public IMotion Motion { get; }

    /// <summary>Start of the motion.</summary>
    public ControlTime Start { get; }

    /// <summary>Samples sent so far. Thread-safe.</summary>
    public long Samples => Interlocked.Read(ref _samples);

    /// <summary>Gets the robot's true position. Thread-safe; allocates nothing.</summary>
    /// <param name="positions">As long as the motion's joint names, rad or m.</param>
    public void TruthAt(ControlTime time, Span<double> positions) => Motion.At(SecondsAt(time), positions);

    /// <summary>Starts to publish to a hub, on a separate thread until disposed.</summary>
    /// <remarks>
    /// After a restart of the gateway, call this again to continue in the new hub. A subscriber that is receiving a sample must not call this
    /// or dispose the cell.
    /// </remarks>
    public void PublishInto(MessageHub hub)
    {
        StopThread();
        _stop.Reset();
        // A higher priority: a late thread would increase the acquisition time beyond its setting.
        _thread = new Thread(() => Publish(hub)) { IsBackground = true, Name = "simulated cell", Priority = ThreadPriority.AboveNormal };
        _thread.Start();
    }

    public void Dispose()
    {
        StopThread();
        _stop.Dispose();
    }

    void Publish(MessageHub hub)
    {
        using var source = hub.OpenSource();
        // Samples that were due without a hub are lost, as with a real cell.
        do
            _schedule.Next();
        while (_schedule.Sent < _clock.Now);
        var nextPlan = _clock.Now;
        var work = _work == null ? null : new WorkMessages(_work);
        if (work != null) source.Publish(work.Stationary(), isStationary: true, []);
        for (; WaitUntil(_schedule.Sent); _schedule.Next())
        {
            if (_setPoints != null && _schedule.Sent >= nextPlan)
            {
                var now = _clock.Now;
                foreach (var robot in _robots) source.Publish(_setPoints.At(now, (now - Start).TotalSeconds), robot: robot);
                nextPlan = now + SetPointsAhead.Interval;
            }
            var positions = new double[_names.Length];
            TruthAt(_schedule.Taken, positions);
            var message = new JointStateMessage(_schedule.Taken, _names, positions);
            foreach (var robot in _robots)
                if (source.Publish(message, robot: robot) == null) Interlocked.Increment(ref _samples);
            if (work != null) PublishWork(work, source, _schedule.Taken);
        }
    }

    void PublishWork(WorkMessages work, HubSource source, ControlTime taken)
    {
        var seconds = SecondsAt(taken);
        foreach (var change in work.ChangesUntil(taken, seconds)) source.Publish(change, []);
        source.Publish(work.FramesAt(taken, seconds), isStationary: false, []);
    }

    double SecondsAt(ControlTime time) => (time - Start).Ticks / (double)TimeSpan.TicksPerSecond;

    // False if stopped.
    bool WaitUntil(ControlTime time) => PreciseWait.While(() => time - _clock.Now, _stop);

    void StopThread()
    {
        _stop.Set();
        _thread?.Join();
        _thread = null;
    }
}
