using System.Buffers.Binary;
using System.Net;
using System.Net.Sockets;
using System.Text;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Compares the tests' RTDE server with bytes that were written by hand from UR's documentation.</summary>
public sealed class RtdeServerTests
{
    PeerProcess _server;
    TcpClient _client;

    [TearDown]
    public void TearDown()
    {
        _client?.Dispose();
        _server?.Dispose();
    }

    [Test]
    public async Task Requests_Version2_AreAnsweredAsDocumentedByUR()
    {
        await StartAsync();

        Assert.That(await AskAsync("0005 56 0002"), Is.EqualTo(Bytes("0004 56 01")));
        Assert.That(await AskAsync("0003 76"), Is.EqualTo(Bytes("0013 76 00000005 0000000b 00000001 0001a71e")));
        // Requests the fields timestamp and actual_q at 125 Hz. The response is recipe 1 with DOUBLE,VECTOR6D.
        Assert.That(
            await AskAsync("001d 4f 405f400000000000" + Ascii("timestamp,actual_q")),
            Is.EqualTo(Bytes("0013 4f 01" + Ascii("DOUBLE,VECTOR6D"))));
        Assert.That(await AskAsync("0003 53"), Is.EqualTo(Bytes("0004 53 01")));
        var (type, first) = await ReadAsync();
        var (_, second) = await ReadAsync();
        Assert.That((type, first.Length, first[0]), Is.EqualTo(((byte)'U', 1 + 8 + 48, (byte)1)));
        Assert.That(Timestamp(second), Is.GreaterThan(Timestamp(first)));
        Assert.That(Timestamp(first), Is.EqualTo(7000).Within(600));
    }

    [Test]
    public async Task Requests_Version1_HaveNoFrequencyAndNoRecipeId()
    {
        await StartAsync();

        Assert.That(await AskAsync("0005 56 0001"), Is.EqualTo(Bytes("0004 56 01")));
        Assert.That(await AskAsync("000c 4f" + Ascii("timestamp")), Is.EqualTo(Bytes("0009 4f" + Ascii("DOUBLE"))));
        Assert.That(await AskAsync("0003 53"), Is.EqualTo(Bytes("0004 53 01")));
        Assert.That((await ReadAsync()).Payload, Has.Length.EqualTo(8));
    }

    [Test]
    public async Task Outputs_UnknownField_ReportsItAndRefusesToStart()
    {
        await StartAsync();
        await AskAsync("0005 56 0002");

        var answer = await AskAsync("001c 4f 405f400000000000" + Ascii("timestamp,no_such"));

        Assert.That(answer, Is.EqualTo(Bytes("0014 4f 00" + Ascii("DOUBLE,NOT_FOUND"))));
        Assert.That(await AskAsync("0003 53"), Is.EqualTo(Bytes("0004 53 00")));
    }

    [TestCase("version-1", "0005 56 0002", "0004 56 00")]
    [TestCase("not-found", "000b 4f 61637475616c5f71", "000c 4f 4e4f545f464f554e44")]
    [TestCase("wrong-type", "000b 4f 61637475616c5f71", "000f 4f 564543544f5236494e543332")]
    public async Task Start_FaultyRequest_ReportsTheFault(string fault, string request, string answer)
    {
        await StartAsync("--fault", fault);

        Assert.That(await AskAsync(request), Is.EqualTo(Bytes(answer)));
    }

    [Test]
    public async Task Pause_WhileStreaming_StopsTheDataUntilTheNextStart()
    {
        await StartAsync();
        await AskAsync("0005 56 0002");
        await AskAsync("0014 4f 405f400000000000" + Ascii("timestamp"));
        await AskAsync("0003 53");
        await ReadAsync();

        await _client.GetStream().WriteAsync(Convert.FromHexString("000350"));
        (byte Type, byte[] Payload) package;
        do package = await ReadAsync();
        while (package.Type == 'U');

        Assert.That(package, Is.EqualTo(((byte)'P', new byte[] { 1 })));
        // The next package is the response, so no data package was sent in between.
        Assert.That(await AskAsync("0003 76"), Does.StartWith("001376"));
        Assert.That(await AskAsync("0003 53"), Is.EqualTo(Bytes("0004 53 01")));
        Assert.That((await ReadAsync()).Type, Is.EqualTo((byte)'U'));
    }

    [Test]
    public async Task Inputs_SeveralRecipes_HaveDifferentIdsAndReportUnknownFields()
    {
        await StartAsync();
        await AskAsync("0005 56 0002");

        Assert.That(await AskAsync("0017 49" + Ascii("input_int_register_0")), Is.EqualTo(Bytes("0009 49 01" + Ascii("INT32"))));
        Assert.That(
            await AskAsync("0031 49" + Ascii("speed_slider_mask,input_double_register_5,x___")),
            Is.EqualTo(Bytes("001b 49 00" + Ascii("UINT32,DOUBLE,NOT_FOUND"))));
        Assert.That(await AskAsync("0018 49" + Ascii("speed_slider_fraction")), Is.EqualTo(Bytes("000a 49 02" + Ascii("DOUBLE"))));
    }

    [Test]
    public async Task Inputs_UsedByAnotherClient_AreInUseUntilThatClientDisconnects()
    {
        await StartAsync();
        const string register = "0017 49";
        var name = Ascii("input_int_register_0");
        using (var other = await ConnectAsync())
        {
            await AskAsync(register + name, other.GetStream());

            Assert.That(await AskAsync(register + name), Is.EqualTo(Bytes("000a 49 00" + Ascii("IN_USE"))));
        }

        string answer;
        do answer = await AskAsync(register + name).Bounded();
        while (answer.EndsWith(Ascii("IN_USE"), StringComparison.Ordinal));
        Assert.That(answer, Is.EqualTo(Bytes("0009 49 01" + Ascii("INT32"))));
    }

    [Test]
    public async Task Package_UnknownType_IsAnsweredWithATextMessage()
    {
        await StartAsync();
        await AskAsync("0005 56 0002");

        // The response contains the length and the characters of the message, the length and the characters of its source, and the level 2 (warning).
        Assert.That(
            await AskAsync("0003 7a"),
            Is.EqualTo(Bytes("0022 4d 18" + Ascii("unknown package type 122") + "04" + Ascii("RTDE") + "02")));
    }

    [Test]
    public async Task Clients_DifferentRecipes_ReceiveTheirFieldsAtTheirFrequency()
    {
        await StartAsync();
        using var other = await ConnectAsync();
        var slow = other.GetStream();

        await AskAsync("0005 56 0002");
        await AskAsync("0014 4f 405f400000000000" + Ascii("timestamp"));
        await AskAsync("0003 53");
        await AskAsync("0005 56 0002", slow);
        // Requests the fields timestamp and runtime_state at 25 Hz.
        await AskAsync("0022 4f 4039000000000000" + Ascii("timestamp,runtime_state"), slow);
        await AskAsync("0003 53", slow);

        var fastTimes = await TimestampsAsync(_client.GetStream(), length: 1 + 8);
        var slowTimes = await TimestampsAsync(slow, length: 1 + 8 + 4);

        // A busy server can skip packages and send the next one late, but it must not send two in one period.
        Assert.That(fastTimes.Select(time => Math.Floor(time / 0.008 + 1e-6)), Is.Unique);
        Assert.That(slowTimes.Select(time => Math.Floor(time / 0.04 + 1e-6)), Is.Unique);
        Assert.That(fastTimes.Zip(fastTimes.Skip(1), (before, after) => after - before).Min(), Is.LessThan(0.039));
    }

    [TestCase("garbage")]
    [TestCase("none")]
    public async Task Clients_OneDisconnectsWhileDataIsSent_OthersAreServed(string fault)
    {
        await StartAsync("--fault", fault);
        for (var i = 0; i < 20; i++)
        {
            using var brief = await ConnectAsync();
            var stream = brief.GetStream();
            await stream.WriteAsync(Convert.FromHexString(Bytes("0005 56 0002 0014 4f 407f400000000000" + Ascii("timestamp") + "0003 53")));
            await stream.ReadExactlyAsync(new byte[64]).AsTask().Bounded();
            brief.LingerState = new LingerOption(true, 0);
        }

        await _client.GetStream().WriteAsync(Convert.FromHexString(Bytes("0003 76")));
        await _client.GetStream().ReadExactlyAsync(new byte[16]).AsTask().Bounded();
    }

    static async Task<double[]> TimestampsAsync(NetworkStream stream, int length)
    {
        var times = new double[10];
        for (var i = 0; i < times.Length; i++)
        {
            var (_, payload) = await ReadAsync(stream);
            Assert.That(payload, Has.Length.EqualTo(length));
            times[i] = Timestamp(payload);
        }

        return times;
    }

    static string Bytes(string hex) => hex.Replace(" ", "");

    static string Ascii(string text) => Convert.ToHexStringLower(Encoding.ASCII.GetBytes(text));

    static double Timestamp(byte[] payload) => BinaryPrimitives.ReadDoubleBigEndian(payload.AsSpan(1));

    async Task<TcpClient> ConnectAsync()
    {
        var client = new TcpClient();
        await client.ConnectAsync(IPAddress.Loopback, int.Parse(_server.ValueOf("endpoint").Split(':')[1]));
        return client;
    }

    async Task StartAsync(params string[] options)
    {
        _server = new PeerProcess("Nowpose.RtdeServer.dll", ["--port", "0", "--uptime", "7000", .. options]);
        await _server.PrintsAsync("state serving");
        _client = await ConnectAsync();
    }

    Task<string> AskAsync(string request) => AskAsync(request, _client.GetStream());

    /// <summary>Sends bytes, and returns size, type and payload of the next package.</summary>
    static async Task<string> AskAsync(string request, NetworkStream stream)
    {
        await stream.WriteAsync(Convert.FromHexString(Bytes(request)));
        var (type, payload) = await ReadAsync(stream);
        return $"{payload.Length + 3:x4}{type:x2}{Convert.ToHexStringLower(payload)}";
    }

    Task<(byte Type, byte[] Payload)> ReadAsync() => ReadAsync(_client.GetStream());

    static async Task<(byte Type, byte[] Payload)> ReadAsync(NetworkStream stream)
    {
        var header = new byte[3];
        await stream.ReadExactlyAsync(header).AsTask().Bounded();
        var payload = new byte[BinaryPrimitives.ReadUInt16BigEndian(header) - header.Length];
        await stream.ReadExactlyAsync(payload).AsTask().Bounded();
        return (header[2], payload);
    }
}
