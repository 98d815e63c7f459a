using System;
using System.Globalization;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Threading.Tasks;
using Nowpose.Messages;

namespace Nowpose.Network
{
    /// <summary>The HTTP request that turns a stream into a WebSocket (RFC 6455, section 4.1), without extensions or subprotocols.</summary>
    static class WebSocketUpgrade
    {
        const string AcceptSalt = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";

        /// <exception cref="GatewayRefusalException">The response is not 101 with the expected Sec-WebSocket-Accept.</exception>
        public static async Task RequestAsync(Stream stream, Uri uri, string token)
        {
            var key = NewKey();
            var request = Encoding.ASCII.GetBytes(Request(uri, key, token));
            await stream.WriteAsync(request).ConfigureAwait(false);
            await stream.FlushAsync().ConfigureAwait(false);
            Check(await HttpHead.ReadAsync(stream).ConfigureAwait(false), key);
        }

        public static string RefusalOf(int status)
        {
            switch (status)
            {
                case 401: return ConnectionMessages.TokenNotAcceptedByHttp;
                case 403: return ConnectionMessages.OriginRefused;
                case 503: return ConnectionMessages.TooManyConnections;
                default: return ConnectionMessages.UpgradeRefused(status.ToString(CultureInfo.InvariantCulture));
            }
        }

        static string Request(Uri uri, string key, string token) =>
            "GET " + uri.PathAndQuery + " HTTP/1.1\r\n" +
            "Host: " + uri.Authority + "\r\n" +
            "Upgrade: websocket\r\n" +
            "Connection: Upgrade\r\n" +
            "Sec-WebSocket-Key: " + key + "\r\n" +
            "Sec-WebSocket-Version: 13\r\n" +
            (token == null ? "" : "Authorization: Bearer " + token + "\r\n") +
            "\r\n";

        static string NewKey()
        {
            var bytes = new byte[16];
            using (var random = RandomNumberGenerator.Create()) random.GetBytes(bytes);
            return Convert.ToBase64String(bytes);
        }

        static void Check(HttpHead head, string key)
        {
            if (head.Status != 101) throw GatewayRefusalException.OfStatus(head.Status);
            if (head.Field("Sec-WebSocket-Accept") != AcceptanceOf(key))
                throw new GatewayRefusalException(ConnectionMessages.NotAWebSocket);
        }

        /// <summary>Returns the value of Sec-WebSocket-Accept with which a server accepts a request with this key (RFC 6455, 4.2.2).</summary>
        internal static string AcceptanceOf(string key)
        {
#pragma warning disable CA5350 // RFC 6455 prescribes SHA-1; here it only shows that the other side is a WebSocket server.
            using (var sha = SHA1.Create())
                return Convert.ToBase64String(sha.ComputeHash(Encoding.ASCII.GetBytes(key + AcceptSalt)));
#pragma warning restore CA5350
        }
    }
}
