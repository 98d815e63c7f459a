using System;
using System.Threading.Tasks;
using Nowpose.Network;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>A session's connections: one for the clock and one for the positions, or one for both with ROS's time.</summary>
    /// <remarks>Connected and disconnected by one thread; read by any.</remarks>
    sealed class SessionConnections : IDisposable
    {
        readonly SessionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> _newLink;
        readonly IRosbridgeListener _listener;
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        SyncClient _syncClient;
        RosbridgeClient _rosbridgeClient;

        /// <param name="newLink">Makes the WebSocket of each attempt to connect.</param>
        /// <param name="listener">Takes the messages.</param>
        /// <param name="synchroniser">Takes the exchanges.</param>
        /// <param name="faults">Exchanges that were dropped.</param>
        public SessionConnections(
            SessionSettings settings, IHeadsetClock clock, Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> newLink,
            IRosbridgeListener listener, ClockSynchroniser synchroniser, SyncFaultCounters faults)
        {
            _settings = settings;
            _clock = clock;
            _newLink = newLink;
            _listener = listener;
            _synchroniser = synchroniser;
            _faults = faults;
        }

        /// <summary>Completes when the connections that were ended are gone.</summary>
        public Task Ended { get; private set; } = Task.CompletedTask;

        /// <summary>Of the clock sync, or the exchanges of ROS's time.</summary>
        public LinkStatus SyncLink => _syncClient?.Status ?? _rosbridgeClient?.ClockStatus ?? LinkStatus.Idle;

        /// <summary>Of the joint positions.</summary>
        public LinkStatus SampleLink => _rosbridgeClient?.Status ?? LinkStatus.Idle;

        public void Connect()
        {
            if (_rosbridgeClient != null) return;
            var (connection, pace) = (_settings.Connection, _settings.NewExchangePace(new Random()));
            var isRos = connection.ClockSource == ControlClockSource.RosTime;
            if (!isRos) _syncClient = new SyncClient(connection, _clock, _synchroniser, _faults, pace);
            _rosbridgeClient = new RosbridgeClient(
                () => _newLink(connection, _clock), _clock, _listener, connection.PublishesDisplayed,
                isRos ? new RosTimeExchanges(_clock, _synchroniser, _faults, pace) : null);
        }

        /// <summary>Ends the connections; waits for nothing.</summary>
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
