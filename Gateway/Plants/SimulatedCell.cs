using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Motion;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Gateway.Plants;

/// <summary>A simulated robot cell that publishes joint positions, objects and signals, and gives access to the true joint positions.</summary>
public sealed class SimulatedCell : IDisposable
{
    readonly IControlClock _clock;
    readonly SampleSchedule _schedule;
    // The joints of each robot.
    readonly string[][] _names;
    readonly ManualResetEventSlim _stop = new();
    // The set-points of each robot; null if the cell publishes none.
    readonly SetPointsAhead[] _setPoints;
    readonly CellWork _work;
    readonly IReadOnlyList<(string Namespace, IMotion Motion)> _robots;
    Thread _thread;

    /// <param name="motion">The motions of the robots. If they move workpieces, the cell also publishes the objects and signals.</param>
    /// <param name="clock">The control clock, with which samples are stamped.</param>
    /// <param name="timing">Sampling interval and acquisition times.</param>
    /// <param name="seed">Seed of the acquisition times.</param>
    /// <param name="publishesPlan">Whether the cell also publishes the set-points of the next second, four times a second.</param>
    internal SimulatedCell(CellMotion motion, IControlClock clock, CellTiming timing, int seed, bool publishesPlan = false)
    {
        _robots = motion.Motions;
        _work = motion.Work;
        _clock = clock;
        _names = [.. _robots.Select(robot => robot.Motion.JointNames.ToArray())];
        Start = clock.Now;
        _setPoints = publishesPlan ? [.. _robots.Select(robot => new SetPointsAhead(robot.Motion))] : null;
        _schedule = new SampleSchedule(Start, timing, seed);
    }

    /// <summary>The motion of the first robot.</summary>
    public IMotion Motion => _robots[0].Motion;

    /// <summary>Control time at which the motion starts.</summary>
    public ControlTime Start { get; }

    /// <summary>Gets the first robot's true joint positions at a given time. Thread-safe.</summary>
    /// <param name="positions">Receives one position per joint name of the motion, rad or m.</param>
    public void TruthAt(ControlTime time, Span<double> positions) => Motion.At(SecondsAt(time), positions);

    /// <summary>Starts a thread that publishes to a hub until the cell is disposed.</summary>
    /// <remarks>
    /// Call this method again after a restart of the gateway, with its new hub. Subscribers must not call this method or
    /// <see cref="Dispose"/> while they receive a sample.
    /// </remarks>
    public void PublishInto(MessageHub hub)
    {
        StopThread();
        _stop.Reset();
        // Gives the thread a higher priority, because a late thread would lengthen the acquisition time beyond its setting.
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
        // Skips the samples that were due before there was a hub. A real cell would also lose them.
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
                for (var i = 0; i < _robots.Count; i++)
                    source.Publish(_setPoints[i].At(now, (now - Start).TotalSeconds), robot: _robots[i].Namespace);
                nextPlan = now + SetPointsAhead.Interval;
            }
            for (var i = 0; i < _robots.Count; i++) source.Publish(SampleOf(i), robot: _robots[i].Namespace);
            if (work != null) PublishWork(work, source, _schedule.Taken);
        }
    }

    JointStateMessage SampleOf(int robot)
    {
        var positions = new double[_names[robot].Length];
        _robots[robot].Motion.At(SecondsAt(_schedule.Taken), positions);
        return new JointStateMessage(_schedule.Taken, _names[robot], positions);
    }

    void PublishWork(WorkMessages work, HubSource source, ControlTime taken)
    {
        var seconds = SecondsAt(taken);
        foreach (var change in work.ChangesUntil(taken, seconds)) source.Publish(change, []);
        source.Publish(work.FramesAt(taken, seconds), isStationary: false, []);
    }

    double SecondsAt(ControlTime time) => (time - Start).Ticks / (double)TimeSpan.TicksPerSecond;

    // Returns false if the cell was stopped before this time.
    bool WaitUntil(ControlTime time) => PreciseWait.While(() => time - _clock.Now, _stop);

    void StopThread()
    {
        _stop.Set();
        _thread?.Join();
        _thread = null;
    }
}
