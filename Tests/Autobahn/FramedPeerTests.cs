using System.Net;
using System.Net.Sockets;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Tests the peer of the Autobahn cases.</summary>
public class FramedPeerTests
{
    [TestCase(true, new byte[] { 0x8A, 0x82, 0, 0, 0, 0, 7, 9 })]
    [TestCase(false, new byte[] { 0x8A, 2, 7, 9 })]
    public async Task Read_Ping_IsAnsweredBetweenTheFramesOfAScript(bool isMasked, byte[] pong)
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        using var near = new TcpClient();
        await near.ConnectAsync((IPEndPoint)listener.LocalEndpoint).Bounded();
        using var far = await listener.AcceptTcpClientAsync().Bounded();
        var peer = new FramedPeer(near.GetStream(), isMasked);
        var script = new CaseScript(isMasked, "", "") { Chop = 1 };
        script.Frame(CaseScript.Text, [1, 2, 3]);
        byte[] frame = [.. script.Chunks.SelectMany(chunk => chunk)];
        var reading = peer.ReadAsync();

        await far.GetStream().WriteAsync(new byte[] { 0x89, 2, 7, 9 });
        await peer.SendAsync(script).Bounded();

        var received = new byte[frame.Length + pong.Length];
        await far.GetStream().ReadExactlyAsync(received).AsTask().Bounded();
        Assert.That(received, Is.EqualTo((byte[])[.. frame, .. pong]).Or.EqualTo((byte[])[.. pong, .. frame]));
        far.Close();
        await reading.Bounded();
    }
}
