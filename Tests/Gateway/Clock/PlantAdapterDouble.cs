using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Simulates an adapter that offers the clock of a control system, like the programs in Gateway/Adapters.</summary>
sealed class PlantAdapterDouble : IDisposable
{
    readonly string _service;
    readonly Func<string, string, string> _answer;
    int _requests;

    PlantAdapterDouble(RawRosbridgeClient client, string service, Func<string, string, string> answer)
    {
        Client = client;
        _service = service;
        _answer = answer;
    }

    public RawRosbridgeClient Client { get; }

    /// <summary>Number of received requests.</summary>
    public int Requests => Volatile.Read(ref _requests);

    /// <param name="clock">Clock of the control system.</param>
    /// <param name="extra">Further fields of the response, after the two times.</param>
    /// <param name="token">Token of the adapter; null for none.</param>
    public static Task<PlantAdapterDouble> ConnectAsync(
        GatewayServer gateway, string name, StopwatchControlClock clock, string extra = "", string token = null) =>
        ConnectAsync(gateway, name, (id, service) => AnswerOf(id, service, clock.Now, clock.Now, extra), token);

    /// <param name="answer">Returns the response to a request with an id and a service name; null sends no response.</param>
    public static async Task<PlantAdapterDouble> ConnectAsync(
        GatewayServer gateway, string name, Func<string, string, string> answer, string token = null)
    {
        var client = await RawRosbridgeClient.ConnectAsync(
            gateway, token == null ? null : options => options.SetRequestHeader("Authorization", $"Bearer {token}"));
        var adapter = new PlantAdapterDouble(client, RosTopics.PlantTime + name, answer);
        await client.SendAsync($$"""{"op":"advertise_service","service":"{{adapter._service}}","type":"nowpose/PlantTime"}""");
        _ = adapter.AnswerAsync();
        return adapter;
    }

    public static string AnswerOf(string id, string service, ControlTime received, ControlTime sent, string extra = "") =>
        $$"""{"op":"service_response","id":"{{id}}","service":"{{service}}","result":true,"values":{"received":{{Time(received)}}"""
        + $$""","sent":{{Time(sent)}}{{extra}} } }""";

    public Task WithdrawAsync() => Client.SendAsync($$"""{"op":"unadvertise_service","service":"{{_service}}"}""");

    public void Dispose() => Client.Dispose();

    async Task AnswerAsync()
    {
        try
        {
            while (true)
            {
                var text = await Client.ReceiveTextAsync();
                if (!RosbridgeReader.TryRead(text, out var question, out _) || question.Op != RosbridgeOp.CallService) continue;
                Interlocked.Increment(ref _requests);
                if (_answer(question.Id.Text, question.Service) is { } answer) await Client.SendAsync(answer);
            }
        }
        catch (Exception)
        {
            // The test has ended, or no request came for a long time.
        }
    }

    static string Time(ControlTime time) =>
        $$"""{"sec":{{time.Nanoseconds / 1_000_000_000}},"nanosec":{{time.Nanoseconds % 1_000_000_000}}}""";
}
