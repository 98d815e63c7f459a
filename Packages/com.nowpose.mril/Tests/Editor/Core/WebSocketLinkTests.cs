using System;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    /// <summary>Tests how a link opens and ends on the class library of this runtime; that of Unity differs from that of .NET.</summary>
    public class WebSocketLinkTests
    {
        /// <summary>Timeout in ms; a test does not wait for it unless it fails.</summary>
        const int TimeoutMs = 30_000;

        TcpListener _server;

        [SetUp]
        public void Listen()
        {
            _server = new TcpListener(IPAddress.Loopback, 0);
            _server.Start();
        }

        [TearDown]
        public void Stop() => _server.Stop();

        [Test]
        public void Open_NoResponseToTheUpgrade_EndsWhenCancelled()
        {
            using (var cancel = new CancellationTokenSource())
            using (var link = NewLink())
            {
                var opening = link.OpenAsync(cancel.Token);
                using (var client = Result(_server.AcceptTcpClientAsync()))
                {
                    Assert.That(Result(client.GetStream().ReadAsync(new byte[1], 0, 1)), Is.EqualTo(1), "the request has arrived");

                    cancel.Cancel();

                    Assert.That(FailureOf(opening), Is.InstanceOf<OperationCanceledException>());
                }
            }
        }

        [TestCase(401, true)]
        [TestCase(403, false)]
        [TestCase(503, false)]
        public void Open_UpgradeRefused_ThrowsWithTheMeaningOfTheStatus(int status, bool isOfToken)
        {
            using (var link = NewLink())
            {
                var opening = link.OpenAsync(CancellationToken.None);
                using (var client = Result(_server.AcceptTcpClientAsync()))
                {
                    Write(client.GetStream(), Encoding.ASCII.GetBytes("HTTP/1.1 " + status + " Refused\r\nContent-Length: 0\r\n\r\n"));

                    var failure = FailureOf(opening) as GatewayRefusalException;

                    Assert.That(failure?.Message, Is.EqualTo(WebSocketUpgrade.RefusalOf(status)).And.Contains("(" + status + ")"));
                    Assert.That(failure.IsOfToken, Is.EqualTo(isOfToken));
                }
            }
        }

        [Test]
        public void Receive_MessageThenClose_ReturnsTheMessageAndTheReason()
        {
            using (var link = NewLink())
            {
                var opening = link.OpenAsync(CancellationToken.None);
                using (var client = Result(_server.AcceptTcpClientAsync()))
                {
                    var stream = client.GetStream();
                    Write(stream, Encoding.ASCII.GetBytes(
                        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: " + AcceptFor(stream) + "\r\n\r\n"));
                    // A text frame, and a close frame with the code 1008.
                    Write(stream, new byte[] { 0x81, 2, (byte)'{', (byte)'}' });
                    Write(stream, new byte[] { 0x88, 6, 0x03, 0xF0, (byte)'S', (byte)'l', (byte)'o', (byte)'w' });
                    Assert.That(opening.Wait(TimeoutMs), Is.True, "opened in time");
                    string text = null;

                    var reason = Result(link.ReceiveAsync(received => text = Encoding.UTF8.GetString(received.Utf8.ToArray()), CancellationToken.None));

                    Assert.That((text, reason), Is.EqualTo(("{}", "Slow")));
                }
            }
        }

        // Reads the request, and returns the value of Sec-WebSocket-Accept.
        static string AcceptFor(NetworkStream stream)
        {
            var head = "";
            while (!head.EndsWith("\r\n\r\n", StringComparison.Ordinal)) head += (char)stream.ReadByte();
            const string Field = "Sec-WebSocket-Key: ";
            return WebSocketUpgrade.AcceptanceOf(head.Substring(head.IndexOf(Field, StringComparison.Ordinal) + Field.Length, 24));
        }

        static void Write(NetworkStream stream, byte[] bytes) => stream.Write(bytes, 0, bytes.Length);

        IWebSocketLink NewLink() => WebSocketLinks.Create(
            new ConnectionSettings("127.0.0.1", webSocketPort: ((IPEndPoint)_server.LocalEndpoint).Port), new StopwatchHeadsetClock());

        static T Result<T>(Task<T> task)
        {
            Assert.That(task.Wait(TimeoutMs), Is.True, "completed in time");
            return task.Result;
        }

        static Exception FailureOf(Task task)
        {
            Assert.That(((IAsyncResult)task).AsyncWaitHandle.WaitOne(TimeoutMs), Is.True, "ended in time");
            return Assert.Catch(() => task.GetAwaiter().GetResult());
        }
    }
}
