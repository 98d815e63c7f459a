using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The clocks of the control system that one client offers. Not thread-safe.</summary>
sealed class PlantTimeOffers(PlantClocks clocks, HubSource client, TimeProvider time, Action<ReadOnlyMemory<byte>> send) : IDisposable
{
    readonly Dictionary<string, Offered> _offers = [];
    // The first clock that the client offered, or a clock without exchanges if there are too many clocks.
    Func<PlantClock> _stampClock;

    /// <summary>
    /// The clock with which this client stamps its messages: the first clock that it offered, as this client tells its time. Null if the client
    /// offers no clock.
    /// </summary>
    public PlantClock StampClock => _stampClock?.Invoke();

    /// <summary>Whether this gateway has started the client, so that it may serve a reserved clock.</summary>
    public bool IsOwnAdapter { private get; set; }

    /// <summary>
    /// Starts to request the time from a service of this client. If another client serves a clock of this name, the requests only measure the
    /// clock with which this client stamps its messages, until the other client disconnects or no longer responds. A client that the gateway has not
    /// started never serves a reserved clock.
    /// </summary>
    /// <param name="rule">The rule that the offer breaks; null for the text of the reason.</param>
    /// <returns>The reason why the client does not serve the clock; <see cref="DropReason.None"/> if it does.</returns>
    public DropReason Offer(string service, out string rule)
    {
        rule = null;
        if (!service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) || !PlantClocks.IsName(service[RosTopics.PlantTime.Length..]))
            return DropReason.UnknownService;
        var name = service[RosTopics.PlantTime.Length..];
        if (!_offers.TryGetValue(service, out var offered))
        {
            if (clocks.Find(name) is not { } clock)
            {
                // There are too many clocks. Stores a clock without exchanges, so that the client's stamps are not used as times on C1.
                var unknown = new PlantClock(name, clocks.Counter);
                _stampClock ??= () => unknown;
                rule = DropMessages.TooManyClocks(PlantClocks.AtMost);
                return DropReason.OutOfRange;
            }

            _offers.Add(service, offered = new Offered(clock, IsOwnAdapter || !clocks.IsReserved(name), asked => NewCaller(asked, service)));
            _stampClock ??= () => offered.Clock;
        }

        if (offered.TryServe()) return DropReason.None;
        rule = offered.MayServe ? DropMessages.ClockTaken : DropMessages.ReservedClock(name);
        return DropReason.JointTaken;
    }

    /// <summary>Lets this client serve each clock whose previous client has disconnected or no longer responds.</summary>
    public void TryAgain()
    {
        foreach (var offered in _offers.Values) offered.TryServe();
    }

    public void Withdraw(string service)
    {
        if (!_offers.Remove(service, out var offered)) return;
        var isStampClock = StampClock == offered.Clock;
        offered.Dispose();
        if (!isStampClock) return;
        var next = _offers.Values.FirstOrDefault();
        _stampClock = next == null ? null : () => next.Clock;
    }

    /// <summary>Passes on a response from the client.</summary>
    /// <param name="response">The response.</param>
    /// <param name="count">Time at which the last byte of the response was read, a timestamp of the hub's time provider.</param>
    public void Answer(RosbridgeMessage response, long count)
    {
        if (_offers.TryGetValue(response.Service, out var offered)) offered.Answer(response, clocks.Counter.At(count));
    }

    public void Dispose()
    {
        foreach (var offered in _offers.Values) offered.Dispose();
        _offers.Clear();
    }

    PlantClockCaller NewCaller(PlantClock clock, string service) => new(
        clock, clocks.Counter, time, id => send(Encoding.UTF8.GetBytes(RosbridgeWriter.CallService(service, id))))
    { Client = client };

    // Another client may serve a clock of the same name but with another time. The stamps of this client are then converted with its own times.
    sealed class Offered(PlantClock served, bool mayServe, Func<PlantClock, PlantClockCaller> newCaller) : IDisposable
    {
        readonly PlantClock _own = new(served.Name, served.Counter);
        PlantClockCaller _caller;

        /// <summary>The served clock if this client serves it; otherwise the clock as measured with this client only.</summary>
        public PlantClock Clock => IsServing ? served : _own;

        /// <summary>Whether this client may serve the clock while no other client does.</summary>
        public bool MayServe => mayServe;

        bool IsServing => _caller != null && served.IsAskedBy(_caller);

        /// <summary>Starts the requests if they are not running. They measure the served clock unless another client serves it.</summary>
        /// <returns>False while another client serves the clock, and always if this client may not serve it.</returns>
        public bool TryServe()
        {
            if (IsServing) return true;
            if (mayServe && served.IsFree)
            {
                var caller = newCaller(served);
                if (served.TryAttach(caller, _own))
                {
                    served.RemoveOther(_own);
                    Start(caller);
                    return true;
                }

                caller.Dispose();
            }

            if (_caller != null && _own.IsAskedBy(_caller)) return false;
            var measuring = newCaller(_own);
            _own.TryAttach(measuring);
            served.AddOther(_own);
            Start(measuring);
            return false;
        }

        public void Answer(RosbridgeMessage response, HeadsetTime arrival) => _caller?.Answer(response, arrival);

        public void Dispose()
        {
            served.RemoveOther(_own);
            _caller?.Dispose();
        }

        void Start(PlantClockCaller caller)
        {
            _caller?.Dispose();
            _caller = caller;
            caller.Start();
        }
    }
}
