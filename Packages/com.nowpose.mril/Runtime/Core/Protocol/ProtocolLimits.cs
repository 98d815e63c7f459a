using System;

namespace Nowpose.Protocol
{
    /// <summary>Every number of the wire protocols, in one place for the headset and the gateway.</summary>
    static class ProtocolLimits
    {
        public const int SyncPort = 47010;
        public const int WebSocketPort = 47011;

        /// <summary>Longest message in bytes of UTF-8, /robot_description excepted.</summary>
        public const int MessageBytes = 64 * 1024;

        /// <summary>Longest message in bytes of UTF-8 that publishes /robot_description.</summary>
        public const int DescriptionBytes = 1024 * 1024;

        /// <summary>Deepest nesting of a message; its outermost object is level 1.</summary>
        public const int Nesting = 16;

        public const int Joints = 256;

        /// <summary>Longest name of a joint, in UTF-16 code units.</summary>
        public const int NameLength = 128;

        public const int TopicsPerClient = 32;
        public const int FragmentsPerMessage = 64;
        public static readonly TimeSpan MessageTimeout = TimeSpan.FromSeconds(5);

        /// <summary>How far a stamp may lie in the future beyond the clock's error bound.</summary>
        public static readonly TimeSpan FutureAllowance = TimeSpan.FromSeconds(1);

        public static readonly TimeSpan PingInterval = TimeSpan.FromSeconds(2);

        /// <summary>No pong for this long closes the WebSocket.</summary>
        public static readonly TimeSpan PongTimeout = TimeSpan.FromSeconds(6);

        /// <summary>How long the answer to a close may take to get out.</summary>
        public static readonly TimeSpan GoodbyeTimeout = TimeSpan.FromSeconds(1);

        /// <summary>Usual time from one sync exchange to the next, ms.</summary>
        public const double SyncIntervalMs = 200;


        /// <summary>How long to wait until a connection is open, TLS included.</summary>
        public static readonly TimeSpan DialTimeout = TimeSpan.FromSeconds(3);

        public static readonly TimeSpan SyncReplyTimeout = TimeSpan.FromSeconds(2);

        /// <summary>How long the server bears a sync connection on which nothing comes.</summary>
        public static readonly TimeSpan SyncSilence = TimeSpan.FromSeconds(60);

        /// <summary>How long a sync connection may stay without an accepted token where one is asked for.</summary>
        public static readonly TimeSpan TokenTimeout = TimeSpan.FromSeconds(5);

        public const int SyncRequestsPerSecond = 100;

        /// <summary>So many dropped exchanges in a row close the sync connection.</summary>
        public const int SyncDropsInARow = 10;

        /// <summary>Longest token, in bytes of UTF-8.</summary>
        public const int TokenBytes = 512;

        /// <summary>Backoff of both connections: first wait, factor, longest wait, and the share by which each wait varies.</summary>
        public static readonly TimeSpan BackoffFirst = TimeSpan.FromMilliseconds(200);
        public const double BackoffFactor = 2;
        public static readonly TimeSpan BackoffLongest = TimeSpan.FromMilliseconds(1500);
        public const double BackoffJitter = 0.2;
    }
}
