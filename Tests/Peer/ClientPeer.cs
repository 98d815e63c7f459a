using System.Net.Security;
using System.Net.WebSockets;
using System.Security.Cryptography.X509Certificates;
using System.Text;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Peer;

/// <summary>A simple rosbridge client that sends each line of its input as a message and prints each message that it receives.</summary>
static class ClientPeer
{
    public static async Task RunAsync(Uri uri, string pin, string token, string origin)
    {
        using var socket = new ClientWebSocket();
        if (pin != null) socket.Options.RemoteCertificateValidationCallback = (_, certificate, _, errors) => IsTrusted(pin, certificate, errors);
        if (token != null) socket.Options.SetRequestHeader("Authorization", "Bearer " + token);
        if (origin != null) socket.Options.SetRequestHeader("Origin", origin);
        try
        {
            await socket.ConnectAsync(uri, CancellationToken.None);
        }
        catch (WebSocketException refused)
        {
            Console.WriteLine("refused: " + refused.Message);
            return;
        }
        Console.WriteLine("connected");
        // Runs on its own thread, because asynchronous reads of the console block.
        await Task.WhenAny(Task.Run(() => SendAsync(socket)), PrintAsync(socket));
    }

    static bool IsTrusted(string pin, X509Certificate certificate, SslPolicyErrors errors) =>
        new ServerTrust(CertificatePin.Parse(pin)).Refusal(certificate, errors, DateTime.Now) == null;

    static async Task SendAsync(ClientWebSocket socket)
    {
        while (await Console.In.ReadLineAsync() is string line)
            await socket.SendAsync(Encoding.UTF8.GetBytes(line), WebSocketMessageType.Text, true, CancellationToken.None);
    }

    static Task PrintAsync(ClientWebSocket socket) => new TextMessageReader(socket, new StopwatchHeadsetClock()).ReceiveAsync(
        next => Console.WriteLine(next.Dropped == DropReason.None ? Encoding.UTF8.GetString(next.Utf8.Span) : "dropped: " + next.Dropped),
        CancellationToken.None);
}
