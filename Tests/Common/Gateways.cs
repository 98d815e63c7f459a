using System.Net;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Tests.Common;

/// <summary>Starts gateways on free ports of loopback.</summary>
static class Gateways
{
    public const string ObserverToken = "observer-token";
    public const string SourceToken = "source-token";
    public const string OperatorToken = "operator-token";

    public static readonly ControlTime Start = ControlTime.FromSeconds(5000);

    public static readonly TokenList Tokens =
        new([(ObserverToken, Role.Observer), (SourceToken, Role.Source), (OperatorToken, Role.Operator)]);

    public static GatewayOptions Options() => new() { SyncPort = 0, WebSocketPort = 0 };

    public static Task<GatewayServer> StartAsync(GatewayOptions options = null, IControlClock clock = null) =>
        GatewayServer.StartAsync(options ?? Options(), clock ?? new StopwatchControlClock(Start)).Bounded();

    public static JointStateMessage State(double position, params string[] names) =>
        new(Start, names, [.. names.Select(_ => position)]);

    /// <summary>Returns a joint state message as a source publishes it.</summary>
    public static string StateText(double position, string name = "a") =>
        RosbridgeWriter.Publish(RosTopics.JointStates, State(position, name), RosTimeForm.Sec);

    public static Uri WebSocketUri(this GatewayServer gateway) =>
        new($"{(gateway.Pin == null ? "ws" : "wss")}://{IPAddress.Loopback}:{gateway.WebSocketEndPoint.Port}/");
}
