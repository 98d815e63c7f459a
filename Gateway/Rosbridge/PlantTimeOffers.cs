using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The clocks of the control system that one client answers for. Called by the thread that handles its messages.</summary>
sealed class PlantTimeOffers(PlantClocks clocks, Action<ReadOnlyMemory<byte>> send) : IDisposable
{
    readonly Dictionary<string, Offered> _offers = [];

    /// <summary>The clock that stamps what this client publishes: the first it offered, whoever answers for it; null without one.</summary>
    public PlantClock StampClock { get; private set; }

    /// <summary>Begins to ask for the time behind a service; where another client answers for that clock, as soon as it does not any more.</summary>
    /// <returns>Why not now; <see cref="DropReason.None"/> also where this client is asked already.</returns>
    public DropReason Offer(string service)
    {
        if (!service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) || !PlantClocks.IsName(service[RosTopics.PlantTime.Length..]))
            return DropReason.UnknownService;
        var name = service[RosTopics.PlantTime.Length..];
        if (!_offers.TryGetValue(service, out var offered))
        {
            if (clocks.Find(name) is not { } clock)
            {
                // Its stamps are not on C1 either: by a clock that nobody asks nothing is mapped.
                StampClock ??= new PlantClock(name, clocks.Counter);
                return DropReason.OutOfRange;
            }

            _offers.Add(service, offered = new Offered(clock, () => NewCaller(clock, service)));
            StampClock ??= clock;
        }

        return offered.TryAsk() ? DropReason.None : DropReason.JointTaken;
    }

    /// <summary>Begins to ask for the clocks that were another client's, where that one is gone or silent.</summary>
    public void TryAgain()
    {
        foreach (var offered in _offers.Values) offered.TryAsk();
    }

    public void Withdraw(string service)
    {
        if (!_offers.Remove(service, out var offered)) return;
        offered.Dispose();
        if (StampClock == offered.Clock) StampClock = _offers.Values.FirstOrDefault()?.Clock;
    }

    /// <param name="count">When its last byte had been read, in counts of <see cref="System.Diagnostics.Stopwatch"/>.</param>
    public void Answer(RosbridgeMessage response, long count)
    {
        if (_offers.TryGetValue(response.Service, out var offered)) offered.Caller?.Answer(response, clocks.Counter.At(count));
    }

    public void Dispose()
    {
        foreach (var offered in _offers.Values) offered.Dispose();
        _offers.Clear();
    }

    PlantClockCaller NewCaller(PlantClock clock, string service) => new(
        clock, clocks.Counter, TimeProvider.System, id => send(Encoding.UTF8.GetBytes(RosbridgeWriter.CallService(service, id))));

    sealed class Offered(PlantClock clock, Func<PlantClockCaller> newCaller) : IDisposable
    {
        public PlantClock Clock => clock;

        /// <summary>Null before this client was asked first.</summary>
        public PlantClockCaller Caller { get; private set; }

        /// <returns>False while another client answers.</returns>
        public bool TryAsk()
        {
            if (Caller != null && clock.IsAskedBy(Caller)) return true;
            if (!clock.IsFree) return false;
            var caller = newCaller();
            if (!clock.TryAttach(caller))
            {
                caller.Dispose();
                return false;
            }

            Caller = caller;
            caller.Start();
            return true;
        }

        public void Dispose() => Caller?.Dispose();
    }
}
