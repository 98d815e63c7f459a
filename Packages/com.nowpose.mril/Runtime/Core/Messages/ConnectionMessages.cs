using System;
using System.Net.Sockets;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Messages
{
    /// <summary>Error messages about the connection to a gateway or a rosbridge server, with remedies.</summary>
    static class ConnectionMessages
    {
        public static string NotAHost(string host) =>
            $"host: '{host}' is neither a host name nor an address; enter the gateway's name or IP address";

        public static string TokenUnencrypted(string host) =>
            $"token: would be sent unencrypted to {host}; enter the gateway's pin, or use a certificate that this device trusts";

        public static string PlainNotAllowed(string host) =>
            $"host: {host} is another machine; enter the gateway's pin, or, on a trusted network only, allow unencrypted connections (Insecure Lan)";

        public static string HeadsetName(int length, int max) => $"headset name: is {length} characters long; allowed: 1 to {max}";
        public static string UnknownClockSource(int source) => $"clock source: {source} is unknown; allowed: 0 (clock sync) and 1 (ROS time)";

        public const string TokenCharacter =
            "token: contains a character that is not allowed in an HTTP header; use ASCII letters, digits and punctuation";

        public const string NotHttp = "the response is not HTTP/1.1; check that host and port are those of a gateway";

        public static string HeadTooLong(int max) =>
            $"the HTTP header of the response is longer than {max} bytes; check that host and port are those of a gateway";

        public const string ClosedBeforeAnswer = "the gateway closed the connection before it responded; see its log";

        public static string NoResponse(double seconds) => FormattableString.Invariant(
            $"no response within {seconds} s; check host and port, the network, the gateway and the firewall of its machine");

        public static string NotResolved(double seconds) => FormattableString.Invariant(
            $"the host name was not resolved within {seconds} s; check the DNS servers of this device, or enter the gateway's IP address");

        /// <summary>Returns the reason for a connection that could not be opened; the system's own text is in the language of the device.</summary>
        /// <param name="isLoopback">Whether the address is one of this device. A gateway listens on it by default.</param>
        public static string NotConnected(string address, bool isLoopback, SocketError error)
        {
            switch (error)
            {
                case SocketError.ConnectionRefused:
                    return address + ": the connection is refused; " + (isLoopback
                        ? "start the gateway on this device, or correct host and port"
                        : "check host and port, and that the gateway is running with --bind any and --tls (or --insecure-lan)");
                case SocketError.HostNotFound:
                case SocketError.NoData:
                case SocketError.TryAgain:
                    return $"{address}: the network does not know this host name; check it, or enter the gateway's IP address";
                // The network capability of UWP or the permission INTERNET of Android is missing, or a firewall refuses the app's connections.
                case SocketError.AccessDenied:
                    return $"{address}: this device does not allow the app to use the network; in Unity's Player settings, declare the capabilities "
                        + "PrivateNetworkClientServer and InternetClient (UWP), or set Internet Access to Require (Android); on a PC, check the firewall";
                default:
                    return $"{address}: the connection failed ({error}); check host and port, the network, and that the gateway is running";
            }
        }

        public static string NothingReceived(double seconds) =>
            FormattableString.Invariant($"received nothing for {seconds} s; check the network, and that the gateway is running");

        public static string TlsFailed(string reason) => $"TLS: {reason}; check that the gateway uses TLS on this port and accepts TLS 1.2";

        public static string NothingSent(double seconds) =>
            FormattableString.Invariant($"nothing could be sent for {seconds} s; check the network");

        public const string RosTimeZero = "the time is zero; with use_sim_time, start the node that publishes /clock";

        public static string RosTimeMissing(DropReason fault) =>
            $"the response contains no time ({fault}); check that rosapi provides the service get_time";

        // A fault of rosbridge_suite before May 2026 (pull request 1255): a call can destroy an object that is still used, and all later calls fail.
        public static string RosCallFailed(string reason) => reason.Contains("'capsule'", StringComparison.Ordinal)
            ? $"{reason}; restart rosbridge, and update rosbridge_suite"
            : $"{reason}; start the node rosapi together with rosbridge, as rosbridge's launch file does";

        public static string RosClockStopped(string service) => $"{service}: the clock does not advance; continue the simulation if it is paused";

        public static string NoAnswer(string service, double seconds) =>
            FormattableString.Invariant($"{service} did not respond within {seconds} s; check the network and rosbridge");

        public static string UnusableAnswers(string service, int count, SyncExchangeFault fault) =>
            $"{service}: {count} consecutive unusable responses, the last: {fault}; check that host and port are those of a rosbridge server";

        public static string UnusableReplies(int count, SyncExchangeFault fault) =>
            $"{count} unusable replies in a row, the last: {fault}; check that host and sync port are those of a gateway";

        public const string TokenNotAccepted = "the gateway does not accept this headset's token; pair again or correct the token";

        /// <param name="reason">The gateway's reason; null or empty if it has given none.</param>
        public static string Closed(string reason = null) => string.IsNullOrEmpty(reason)
            ? "the gateway closed the connection; see its log"
            : $"the gateway closed the connection ({reason}); see its log";

        public static string Reported(string error) => $"the gateway reports: {error}";

        public static string NotASyncFrame(SyncFrameFault fault) =>
            $"the reply is not a sync frame: {fault}; check that host and sync port are those of a gateway";

        public static string OtherSyncFrame(SyncFrameKind kind, SyncFrameKind expected) =>
            $"the reply is a frame of kind {kind} instead of {expected}; check that host and sync port are those of a gateway";

        public static string MessageTooLong(int max) =>
            $"a message was longer than the maximum of {max} bytes; reduce the joints or objects in each message";
        public static string MessageTooSlow(double seconds) =>
            FormattableString.Invariant($"a message was not complete within {seconds} s; check the network");

        public const string TokenNotAcceptedByHttp = "the gateway does not accept this headset's token (401); pair again or correct the token";

        public const string OriginRefused =
            "the gateway refuses requests from another origin (403); use the address that the gateway was started with";

        public const string TooManyConnections =
            "the gateway has reached its maximum number of connections (503); close connections that are not needed, or raise --max-connections";

        public static string UpgradeRefused(string status) =>
            $"the gateway responded to the WebSocket request with status {status}; check that host and port are those of a gateway";

        public const string NotAWebSocket = "the server does not accept the WebSocket request; check that it is a gateway";

        public static string OtherVersion(string name, string version, string self, string ownVersion) =>
            $"{name} has version {version}, but {self} has {ownVersion}; install the same version of both";

        public const string Lost = "the connection was lost; check the network, and that the gateway is running";

        public static string NoPinCheck(string replacement) => $"NativeWebSocket cannot check a pin; use {replacement}";
    }
}
