using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>An adapter that answers for a clock of its own, as the programs in Gateway/Adapters do.</summary>
sealed class PlantAdapterDouble : IDisposable
{
    readonly string _service;
    readonly Func<string, string, string> _answer;
    int _questions;

    PlantAdapterDouble(RawRosbridgeClient client, string service, Func<string, string, string> answer)
    {
        Client = client;
        _service = service;
        _answer = answer;
    }

    public RawRosbridgeClient Client { get; }

    /// <summary>How often it was asked.</summary>
    public int Questions => Volatile.Read(ref _questions);

    /// <param name="clock">Of the control system.</param>
    /// <param name="extra">Fields of the answer beside the two times.</param>
    public static Task<PlantAdapterDouble> ConnectAsync(GatewayServer gateway, string name, StopwatchControlClock clock, string extra = "") =>
        ConnectAsync(gateway, name, (id, service) => AnswerOf(id, service, clock.Now, clock.Now, extra));

    /// <param name="answer">Takes id and service of a question; null for no answer.</param>
    public static async Task<PlantAdapterDouble> ConnectAsync(GatewayServer gateway, string name, Func<string, string, string> answer)
    {
        var client = await RawRosbridgeClient.ConnectAsync(gateway);
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
                Interlocked.Increment(ref _questions);
                if (_answer(question.Id, question.Service) is { } answer) await Client.SendAsync(answer);
            }
        }
        catch (Exception)
        {
            // The test is over, or nothing was asked for long.
        }
    }

    static string Time(ControlTime time) =>
        $$"""{"sec":{{time.Nanoseconds / 1_000_000_000}},"nanosec":{{time.Nanoseconds % 1_000_000_000}}}""";
}
