using System;
using System.Threading.Tasks;
using Nowpose.Network;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>
    /// Connections of a session: one for the clock and one for joint positions. With ROS time, a single connection serves both purposes.
    /// </summary>
    /// <remarks>Connect and disconnect on one thread; properties can be read on any thread.</remarks>
    sealed class SessionConnections : IDisposable
    {
        readonly SessionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> _newLink;
        readonly IRosbridgeListener _listener;
        readonly Subscriptions _subscriptions;
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        SyncClient _syncClient;
        RosbridgeClient _rosbridgeClient;

        /// <param name="newLink">Creates the WebSocket for each connection attempt.</param>
        /// <param name="listener">Receives the messages.</param>
        /// <param name="subscriptions">Topics to subscribe to.</param>
        /// <param name="synchroniser">Receives the sync exchanges.</param>
        /// <param name="faults">Counts of dropped exchanges.</param>
        public SessionConnections(
            SessionSettings settings, IHeadsetClock clock, Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> newLink,
            IRosbridgeListener listener, Subscriptions subscriptions, ClockSynchroniser synchroniser, SyncFaultCounters faults)
        {
            _settings = settings;
            _clock = clock;
            _newLink = newLink;
            _listener = listener;
            _subscriptions = subscriptions;
            _synchroniser = synchroniser;
            _faults = faults;
        }

        /// <summary>Completes when the ended connections have released all resources.</summary>
        public Task Ended { get; private set; } = Task.CompletedTask;

        /// <summary>Status of the clock sync connection, or of the exchanges with ROS time.</summary>
        public LinkStatus SyncLink => _syncClient?.Status ?? _rosbridgeClient?.ClockStatus ?? LinkStatus.Idle;

        /// <summary>Status of the connection for joint positions.</summary>
        public LinkStatus SampleLink => _rosbridgeClient?.Status ?? LinkStatus.Idle;

        /// <summary>Whether a connection was ever requested. Without a request, a program in this process supplies the messages.</summary>
        public bool WasRequested { get; private set; }

        public void Connect()
        {
            if (_rosbridgeClient != null) return;
            WasRequested = true;
            var (connection, pace) = (_settings.Connection, _settings.NewExchangePace(new Random()));
            var isRos = connection.ClockSource == ControlClockSource.RosTime;
            if (!isRos) _syncClient = new SyncClient(connection, _clock, _synchroniser, _faults, pace, () => _rosbridgeClient?.EndIfSilent());
            _rosbridgeClient = new RosbridgeClient(
                () => _newLink(connection, _clock), _clock, _listener, _subscriptions, connection.PublishesDisplayed,
                isRos ? new RosTimeExchanges(_clock, _synchroniser, _faults, pace) : null);
        }

        /// <summary>Ends the connections without waiting.</summary>
        public void Disconnect()
        {
            if (_rosbridgeClient == null) return;
            _rosbridgeClient.Dispose();
            _syncClient?.Dispose();
            Ended = Task.WhenAll(Ended, _rosbridgeClient.Ended, _syncClient?.Ended ?? Task.CompletedTask);
            _rosbridgeClient = null;
            _syncClient = null;
        }

        public void Dispose() => Disconnect();
    }
}
