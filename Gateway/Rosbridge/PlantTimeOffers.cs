using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The clocks of the control system that one client offers. Not thread-safe.</summary>
sealed class PlantTimeOffers(PlantClocks clocks, Action<ReadOnlyMemory<byte>> send) : IDisposable
{
    readonly Dictionary<string, Offered> _offers = [];

    /// <summary>
    /// The clock with which this client stamps its messages: the first clock that it offered, even if another client serves the clock at
    /// present. Null if the client offers no clock.
    /// </summary>
    public PlantClock StampClock { get; private set; }

    /// <summary>
    /// Starts to request the time from a service of this client. If another client serves the same clock, the requests start when that client
    /// disconnects or no longer responds.
    /// </summary>
    /// <returns>The reason why no requests are sent; <see cref="DropReason.None"/> if requests are sent.</returns>
    public DropReason Offer(string service)
    {
        if (!service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) || !PlantClocks.IsName(service[RosTopics.PlantTime.Length..]))
            return DropReason.UnknownService;
        var name = service[RosTopics.PlantTime.Length..];
        if (!_offers.TryGetValue(service, out var offered))
        {
            if (clocks.Find(name) is not { } clock)
            {
                // There are too many clocks. Stores a clock without exchanges, so that the client's stamps are not used as times on C1.
                StampClock ??= new PlantClock(name, clocks.Counter);
                return DropReason.OutOfRange;
            }

            _offers.Add(service, offered = new Offered(clock, () => NewCaller(clock, service)));
            StampClock ??= clock;
        }

        return offered.TryAsk() ? DropReason.None : DropReason.JointTaken;
    }

    /// <summary>Starts the requests to this client for each clock whose previous client has disconnected or no longer responds.</summary>
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

    /// <summary>Passes on a response from the client.</summary>
    /// <param name="response">The response.</param>
    /// <param name="count">Time at which the last byte of the response was read, as a <see cref="System.Diagnostics.Stopwatch"/> timestamp.</param>
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

        /// <summary>Sends the requests; null before the first request to this client.</summary>
        public PlantClockCaller Caller { get; private set; }

        /// <summary>Starts the requests if they are not running and no other client serves the clock.</summary>
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
