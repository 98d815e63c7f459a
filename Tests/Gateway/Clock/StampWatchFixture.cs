using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>A watch of the time stamps of several sources, in virtual time.</summary>
public abstract class StampWatchFixture
{
    private protected static readonly TimeSpan Second = TimeSpan.FromSeconds(1);
    private protected static readonly TimeSpan Acquisition = TimeSpan.FromMilliseconds(70);

    private protected readonly List<string> _log = [];
    private protected readonly OwnClock _own = new();
    private protected HubSource[] _sources;
    private protected SteppedTime _time;
    private protected StampWatch _watch;
    private protected TimeSpan _correction;
    private protected TimeSpan _errorBound;
    private protected TimeSpan _plantAhead;
    private protected TimeSpan? _offeredBound;
    private protected bool _isOwnServed;

    private protected ControlTime System => _own.Now + _correction;

    [SetUp]
    public void SetUp()
    {
        (_time, _correction, _errorBound, _isOwnServed) = (new SteppedTime(), TimeSpan.Zero, TimeSpan.Zero, true);
        _own.Time = _time;
        var hub = new MessageHub();
        _sources = [.. new[] { "first", "second", "third" }.Select(name => Open(hub, name))];
        _log.Clear();
        (_plantAhead, _offeredBound) = (TimeSpan.Zero, null);
        _watch = new StampWatch(
            () => _own.Now + _plantAhead, () => _isOwnServed ? "own" : "plc", () => _errorBound, () => _isOwnServed ? _own : null, () => System, false, _time);
        _watch.Look(_log.Add);
    }

    private protected static HubSource Open(MessageHub hub, string name)
    {
        var source = hub.OpenSource();
        source.Name = name;
        return source;
    }

    private protected void Run(int seconds, params Func<ControlTime>[] sources) => Run(_watch, _own, seconds, sources);

    // Adds ten samples per second from each source, and checks the time stamps once per second.
    private protected void Run(StampWatch watch, IControlClock control, int seconds, params Func<ControlTime>[] sources)
    {
        for (var i = 0; i < seconds * 10; i++)
        {
            _time.Advance(Second / 10);
            foreach (var (source, name) in sources.Zip(_sources))
            {
                var stamp = source() - Acquisition;
                watch.Add(name, stamp, stamp > control.Now + Second, _offeredBound);
            }

            if (i % 10 == 9) watch.Look(_log.Add);
        }
    }

    private protected sealed class OwnClock : IControlClock
    {
        public TimeProvider Time { get; set; }
        public double Skew { get; set; }
        public ControlTime Now => ControlTime.FromSeconds(1e9 + Time.GetElapsedTime(0).TotalSeconds);
    }
}
