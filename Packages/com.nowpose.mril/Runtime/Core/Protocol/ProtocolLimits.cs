using System;

namespace Nowpose.Protocol
{
    /// <summary>Limits of the wire protocols, shared by headset and gateway.</summary>
    static class ProtocolLimits
    {
        public const int SyncPort = 47010;
        public const int WebSocketPort = 47011;

        /// <summary>Maximum length of a message in bytes of UTF-8, except /robot_description.</summary>
        public const int MessageBytes = 64 * 1024;

        /// <summary>Maximum length in bytes of UTF-8 of a message that publishes /robot_description.</summary>
        public const int DescriptionBytes = 1024 * 1024;

        /// <summary>Maximum nesting of a message; its outermost object is level 1.</summary>
        public const int Nesting = 16;

        public const int Joints = 256;

        /// <summary>Maximum length of a joint name without the namespace of its robot, in UTF-16 code units.</summary>
        public const int NameLength = 128;

        /// <summary>
        /// Maximum length of a key of diagnostics and of the id of a subscription, in UTF-16 code units. A key is a name with its namespace, after a
        /// prefix; clients also make ids from the name of the topic.
        /// </summary>
        public const int KeyLength = 256;

        /// <summary>Maximum number of robots in namespaces per gateway; the robot without a namespace is not counted.</summary>
        public const int Robots = 16;

        /// <summary>Maximum length of a robot's namespace, in characters.</summary>
        public const int NamespaceLength = 32;

        /// <summary>Maximum number of frames in a cell, and in one message.</summary>
        public const int Frames = 256;

        /// <summary>Maximum number of transforms from a frame to its root.</summary>
        public const int FrameDepth = 16;

        /// <summary>Maximum number of signals in a cell, and in one message.</summary>
        public const int Signals = 256;

        public const int TopicsPerClient = 64;

        /// <summary>Maximum number of subscriptions of a client to one topic; they differ in their ids.</summary>
        public const int SubscriptionsPerTopic = 64;

        public const int FragmentsPerMessage = 64;
        public static readonly TimeSpan MessageTimeout = TimeSpan.FromSeconds(5);

        /// <summary>Maximum time by which a stamp may be in the future, in addition to the clock's error bound.</summary>
        public static readonly TimeSpan FutureAllowance = TimeSpan.FromSeconds(1);

        public static readonly TimeSpan PingInterval = TimeSpan.FromSeconds(2);

        /// <summary>
        /// Silence of a WebSocket after which data may be lost. A working one is silent for less, because after <see cref="PingInterval"/> the headset
        /// asks the gateway for a response, together with the diagnostics of each second.
        /// </summary>
        public static readonly TimeSpan MaxSilence = TimeSpan.FromMilliseconds(3500);

        /// <summary>
        /// Timeout of the WebSocket: the gateway closes the WebSocket if no pong arrives, and the headset closes it if no message arrives. Also the
        /// headset's timeout for opening it.
        /// </summary>
        public static readonly TimeSpan PongTimeout = TimeSpan.FromSeconds(6);

        /// <summary>Timeout for sending the reply to a close frame.</summary>
        public static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(1);

        /// <summary>Usual interval of sync exchanges, in ms.</summary>
        public const double SyncIntervalMs = 200;


        /// <summary>Timeout for opening a connection, including TLS.</summary>
        public static readonly TimeSpan DialTimeout = TimeSpan.FromSeconds(3);

        public static readonly TimeSpan SyncReplyTimeout = TimeSpan.FromSeconds(2);

        /// <summary>Time without data after which the server closes a sync connection.</summary>
        public static readonly TimeSpan SyncSilence = TimeSpan.FromSeconds(60);

        /// <summary>Time without an accepted token after which the server closes a sync connection, if it requires a token.</summary>
        public static readonly TimeSpan TokenTimeout = TimeSpan.FromSeconds(5);

        public const int SyncRequestsPerSecond = 100;

        /// <summary>Number of consecutive dropped exchanges after which the sync connection is closed.</summary>
        public const int SyncDropsInARow = 10;

        /// <summary>Maximum length of a token, in bytes of UTF-8.</summary>
        public const int TokenBytes = 512;

        /// <summary>
        /// Backoff of the sync connection and of the WebSocket connection: first delay, factor, maximum delay, and the relative random
        /// variation of each delay.
        /// </summary>
        public static readonly TimeSpan BackoffFirst = TimeSpan.FromMilliseconds(200);
        public const double BackoffFactor = 2;
        public static readonly TimeSpan BackoffLongest = TimeSpan.FromMilliseconds(1500);
        public const double BackoffJitter = 0.2;

        /// <summary>Duration of a connection after which the next delay is the first delay again.</summary>
        public static readonly TimeSpan BackoffReset = TimeSpan.FromSeconds(10);
    }
}
