using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The clocks of the control system that one client offers. Called by the thread that handles its messages.</summary>
sealed class PlantTimeOffers(PlantClocks clocks, Action<ReadOnlyMemory<byte>> send) : IDisposable
{
    readonly Dictionary<string, Offered> _offers = [];

    /// <summary>The clock that stamps this client's messages: the first it offered, whichever client serves it; null if there is none.</summary>
    public PlantClock StampClock { get; private set; }

    /// <summary>
    /// Starts to request the time from a service. If another client serves that clock, the requests start when that client stops.
    /// </summary>
    /// <returns>The reason for a refusal; <see cref="DropReason.None"/> otherwise, and if the requests were already running.</returns>
    public DropReason Offer(string service)
    {
        if (!service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) || !PlantClocks.IsName(service[RosTopics.PlantTime.Length..]))
            return DropReason.UnknownService;
        var name = service[RosTopics.PlantTime.Length..];
        if (!_offers.TryGetValue(service, out var offered))
        {
            if (clocks.Find(name) is not { } clock)
            {
                // The client's stamps are not on C1. A clock without exchanges keeps them from being mapped.
                StampClock ??= new PlantClock(name, clocks.Counter);
                return DropReason.OutOfRange;
            }

            _offers.Add(service, offered = new Offered(clock, () => NewCaller(clock, service)));
            StampClock ??= clock;
        }

        return offered.TryAsk() ? DropReason.None : DropReason.JointTaken;
    }

    /// <summary>Starts the requests to this client for clocks whose former client has disconnected or is silent.</summary>
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

    /// <param name="count">Time at which its last byte was read, a count of <see cref="System.Diagnostics.Stopwatch"/>.</param>
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

        /// <summary>Null before the first request to this client.</summary>
        public PlantClockCaller Caller { get; private set; }

        /// <returns>False while another client serves the clock.</returns>
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
