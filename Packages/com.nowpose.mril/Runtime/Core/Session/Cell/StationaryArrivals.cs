using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Session.Cell
{
    /// <summary>The poses of stationary frames, which a source sends only once or a user has placed by hand, and their arrival times.</summary>
    sealed class StationaryArrivals
    {
        /// <summary>
        /// Time after which a pose that has not been sent again since a connection was restored is not current. A gateway sends its poses at once. The
        /// sources of a gateway that has restarted connect to it again within 1.8 s.
        /// </summary>
        static readonly TimeSpan Patience = ClockTicks.Span(2.5);

        readonly ConnectionStart _connection;
        readonly Dictionary<string, Arrival> _arrivals = new Dictionary<string, Arrival>(StringComparer.Ordinal);

        public StationaryArrivals(ConnectionStart connection) => _connection = connection;

        /// <summary>Records the arrival of a pose that was used.</summary>
        /// <param name="isByHand">Whether a user has placed the frame, so that its pose depends neither on the connection nor on the order of the arrivals.</param>
        public void Add(in FrameTransform pose, HeadsetTime arrival, bool isByHand = false) =>
            _arrivals[pose.Child] = new Arrival(pose, arrival, isByHand);

        /// <summary>Records that a frame is now tracked, or that another one has replaced it.</summary>
        public void Remove(string frame) => _arrivals.Remove(frame);

        /// <summary>
        /// Returns whether the stationary pose of a frame arrived later than a tracked pose. Tracked poses wait for a known control time, stationary ones do
        /// not.
        /// </summary>
        public bool IsLater(string frame, HeadsetTime arrivalOfTracked) =>
            _arrivals.TryGetValue(frame, out var arrival) && !arrival.IsByHand && arrival.At >= arrivalOfTracked;

        /// <summary>
        /// Marks the frames of a tree whose poses have not been sent again in time. The time counts from the first connection after the pose, so that a
        /// connection that is lost again and again does not postpone the mark.
        /// </summary>
        public void Mark(FrameTree tree, HeadsetTime now)
        {
            foreach (var known in _arrivals)
            {
                var arrival = known.Value;
                if (!IsBeforeConnection(arrival)) continue;
                arrival.AwaitedSince ??= _connection.Newest;
                if (now - arrival.AwaitedSince >= Patience && tree.IndexOf(known.Key) is var index && index >= 0) tree[index].IsOutdated = true;
            }
        }

        /// <summary>Returns whether the source of a stationary pose sent it before the newest connection, and not again since.</summary>
        public bool IsBeforeConnection(string frame) => _arrivals.TryGetValue(frame, out var arrival) && IsBeforeConnection(arrival);

        bool IsBeforeConnection(Arrival arrival) => !arrival.IsByHand && !_connection.Includes(arrival.At);

        /// <summary>Reports the newest pose of each frame with its arrival.</summary>
        public void Report(PoseJudged report)
        {
            foreach (var known in _arrivals) report(known.Value.Pose, isStationary: true, known.Value.At, DropReason.None);
        }

        sealed class Arrival
        {
            public Arrival(in FrameTransform pose, HeadsetTime at, bool isByHand) => (Pose, At, IsByHand) = (pose, at, isByHand);

            public FrameTransform Pose { get; }

            public HeadsetTime At { get; }

            public bool IsByHand { get; }

            /// <summary>Start of the first connection after the pose; null before such a connection.</summary>
            public HeadsetTime? AwaitedSince { get; set; }
        }
    }
}
