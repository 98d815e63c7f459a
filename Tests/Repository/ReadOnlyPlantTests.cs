using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks that adapters can only read from control systems: only two files use the client libraries, and they allow only read requests.
/// </summary>
public sealed partial class ReadOnlyPlantTests
{
    const string Sources = "Gateway/Adapters/src";

    static readonly Dictionary<string, string> ReadOnlyFiles = new()
    {
        [Sources + "/opcua/readOnlySession.ts"] = "ALLOWED", [Sources + "/ads/readOnlyClient.ts"] = "READING",
    };

    [GeneratedRegex(@"import\s+(?:\{[^}]*\}|[^;{]*)\s+from '(?:node-opcua-client|ads-client)'")]
    private static partial Regex LibraryImport();

    // Matches a use as a value; a use as a type cannot send requests.
    [GeneratedRegex(@"(?<!type )\b(?:OPCUAClient|Client|ClientSession)\b")]
    private static partial Regex ClientAsValue();

    [GeneratedRegex(@"\.(?:write(?:SingleNode|Raw\w*|Value|Symbol)?|callMethod|writeControl|startPlc|stopPlc|restartPlc|setTcSystemTo\w+|invokeRpcMethod)\(")]
    private static partial Regex WritingCall();

    [GeneratedRegex(@"packageOf\('(\w+)'")]
    private static partial Regex RtdeRequest();

    [Test]
    public void Rtde_Requests_AreReadOnly()
    {
        const string packages = Sources + "/rtde/packages.ts", connection = Sources + "/rtde/connection.ts";
        var sources = RepositoryFiles.Under(Sources + "/rtde", ".ts").ToArray();

        var requests = sources.SelectMany(file => RtdeRequest().Matches(RepositoryFiles.Read(file)).Select(call => (file, call.Groups[1].Value)));
        var sending = sources.Where(file => RepositoryFiles.Read(file).Contains(".write("));

        Assert.That(requests, Is.EquivalentTo(
            new[] { "protocolVersion", "controllerVersion", "setUpOutputs", "start" }.Select(request => (packages, request))));
        Assert.That(sending, Is.EqualTo(new[] { connection }));
    }

    [Test]
    public void ControlSystems_Access_IsOnlyThroughReadOnlyClasses()
    {
        var reaching = RepositoryFiles.Under(Sources, ".ts")
            .Where(file => LibraryImport().Matches(RepositoryFiles.Read(file)).Any(import => ClientAsValue().IsMatch(import.Value)));

        Assert.That(reaching, Is.EquivalentTo(ReadOnlyFiles.Keys));
        foreach (var (file, list) in ReadOnlyFiles)
            Assert.That(RepositoryFiles.Read(file).Split(list).Length, Is.GreaterThan(2), $"{file} has a list of allowed requests and checks it");
    }

    [Test]
    public void Adapters_OfControlSystems_CallNoWritingMethods()
    {
        var writing = RepositoryFiles.Under(Sources + "/opcua", ".ts").Concat(RepositoryFiles.Under(Sources + "/ads", ".ts"))
            .SelectMany(file => WritingCall().Matches(RepositoryFiles.Read(file)).Select(call => $"{file}: {call.Value}"));

        Assert.That(writing, Is.Empty);
    }
}
