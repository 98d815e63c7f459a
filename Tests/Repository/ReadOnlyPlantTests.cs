using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks that adapters can only read from control systems: only the listed files open connections, and each kind of plant has only the listed calls
/// that send something. A new file, library or kind fails until it is listed here.
/// </summary>
public sealed partial class ReadOnlyPlantTests
{
    const string Sources = "Gateway/Adapters/src";

    /// <summary>All files that can open a connection, and the modules that they use for it.</summary>
    static readonly string[] Connections =
    [
        "ads/readOnlyClient.ts: ads-client", "opcua/readOnlySession.ts: node-opcua-client",
        "mqtt/link.ts: mqtt",
        "rtde/connection.ts: node:net", "rtde/calibration/primary.ts: node:net",
        // To gateways; the first one also to the rosbridge of a robot.
        "gateway/link.ts: ws", "gateway/pin.ts: node:https", "gateway/pin.ts: node:tls",
        "broker/syncClient.ts: node:net", "broker/syncClient.ts: node:tls",
    ];

    /// <summary>Modules that open no connection.</summary>
    static readonly HashSet<string> Local =
    [
        "node:crypto", "node:events", "node:fs", "node:os", "node:path", "node:stream", "node:util", "node-opcua-debug", "plant.schema", "yaml",
    ];

    /// <summary>Values of the client libraries that send nothing without a session or a client.</summary>
    static readonly HashSet<string> Data = ["ADS", "ClientSubscription", "crypto_utils", "DataType", "StatusCodes", "UserTokenType", "VariantArrayType"];

    /// <summary>For each kind of plant, the calls that may send something, and the only ones in its files.</summary>
    static readonly Dictionary<string, (Regex Calls, string[] Allowed)> Sending = new()
    {
        ["opcua"] = (WritingCall(), []),
        ["ads"] = (WritingCall(), []),
        ["rtde"] = (RtdeCall(), ["packageOf('controllerVersion'", "packageOf('protocolVersion'", "packageOf('setUpOutputs'", "packageOf('start'", "socket.write("]),
        ["mqtt"] = (MqttCall(), ["client.subscribe("]),
        ["ros"] = (RosCall(), ["robot.call(", "robot.renewSilentSubscriptions(", "robot.run(", "robot.subscribe("]),
        // A bridge publishes on a broker, but only below the topic of its own plant.
        ["broker"] = (MqttCall(), ["client.publish(this.#at("]),
    };

    [GeneratedRegex(@"\b(?:import|export)\s+(?!type\b)(?:([^;']*?)\s+from )?'([^'.][^']*)'")]
    private static partial Regex Import();

    // Loads a module, or opens a connection without one.
    [GeneratedRegex(@"\b(?:require\(|import\((?!new URL\(`\./\$\{kind\}\.mjs`)|fetch\(|new EventSource\(|new WebSocket\()")]
    private static partial Regex OtherAccess();

    [GeneratedRegex(@"\.(?:write(?:SingleNode|Raw\w*|Value|Symbol)?|callMethod|writeControl|startPlc|stopPlc|restartPlc|setTcSystemTo\w+|invokeRpcMethod)\(")]
    private static partial Regex WritingCall();

    [GeneratedRegex(@"packageOf\('\w+'|\w+\.write\(")]
    private static partial Regex RtdeCall();

    [GeneratedRegex(@"\bclient\??\.(?!connected\b|stream\b|(?:close|end|on|once|read)\()\w+\((?:this\.#at\()?")]
    private static partial Regex MqttCall();

    [GeneratedRegex(@"\brobot\.\w+\(")]
    private static partial Regex RosCall();

    [Test]
    public void ControlSystems_Access_IsOnlyThroughReadOnlyClasses()
    {
        var files = RepositoryFiles.Under(Sources, ".ts").Where(file => !file.EndsWith(".d.ts", StringComparison.Ordinal)).ToList();

        Assert.That(files.SelectMany(ConnectionsIn), Is.EquivalentTo(Connections));
        // This file imports the class from the module ws.
        Assert.That(files.SelectMany(file => CallsIn(file, OtherAccess()).Select(call => $"{file}: {call}")),
            Is.EqualTo(new[] { $"{Sources}/gateway/link.ts: new WebSocket(" }));
        foreach (var (file, list) in new[] { ("opcua/readOnlySession.ts", "ALLOWED"), ("ads/readOnlyClient.ts", "READING") })
            Assert.That(RepositoryFiles.Read($"{Sources}/{file}").Split(list).Length, Is.GreaterThan(2), $"{file} has a list of allowed requests and checks it");
    }

    [Test]
    public void Adapters_OfControlSystems_CallNoWritingMethods()
    {
        using var schema = JsonDocument.Parse(RepositoryFiles.Read("Gateway/Adapters/plant.schema.json"));
        var kinds = schema.RootElement.GetProperty("properties").GetProperty("plant").GetProperty("properties").GetProperty("kind").GetProperty("enum");

        Assert.That(kinds.EnumerateArray().Select(kind => kind.GetString()), Is.EquivalentTo(Sending.Keys));
        foreach (var (kind, (calls, allowed)) in Sending)
            Assert.That(RepositoryFiles.Under($"{Sources}/{kind}", ".ts").SelectMany(file => CallsIn(file, calls)).Distinct(), Is.EquivalentTo(allowed), kind);
    }

    static IEnumerable<string> ConnectionsIn(string file) =>
        from import in Import().Matches(RepositoryFiles.Read(file))
        let module = import.Groups[2].Value
        where !Local.Contains(module)
        let names = import.Groups[1].Value.Trim('{', '}').Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries)
        where names.Length == 0 || names.Any(name => !name.StartsWith("type ", StringComparison.Ordinal) && !Data.Contains(name.Split(' ')[0]))
        select $"{file[(Sources.Length + 1)..]}: {module}";

    static IEnumerable<string> CallsIn(string file, Regex calls) => calls.Matches(RepositoryFiles.Read(file)).Select(call => call.Value.Replace("?.", "."));
}
