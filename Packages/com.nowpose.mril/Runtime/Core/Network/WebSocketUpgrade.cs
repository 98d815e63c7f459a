using System;
using System.Globalization;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>The HTTP request that turns a stream into a WebSocket (RFC 6455, section 4.1), without extensions or subprotocols.</summary>
    static class WebSocketUpgrade
    {
        const int LongestHead = 8 * 1024;
        const string AcceptSalt = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";

        /// <exception cref="GatewayRefusalException">The answer is not 101 with the right acceptance.</exception>
        public static async Task RequestAsync(Stream stream, Uri uri, string token)
        {
            var key = NewKey();
            var request = Encoding.ASCII.GetBytes(Request(uri, key, token));
            await stream.WriteAsync(request).ConfigureAwait(false);
            await stream.FlushAsync().ConfigureAwait(false);
            Check(await ReadHeadAsync(stream).ConfigureAwait(false), key);
        }

        public static string RefusalOf(int status)
        {
            switch (status)
            {
                case 401: return "the gateway does not accept this headset's token (401)";
                case 403: return "the gateway refuses requests from another origin (403)";
                default: return "the gateway answered the WebSocket request with status " + status.ToString(CultureInfo.InvariantCulture);
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

        // Byte by byte: what follows the head belongs to the WebSocket already.
        static async Task<string> ReadHeadAsync(Stream stream)
        {
            var head = new StringBuilder();
            var one = new byte[1];
            while (!EndsHead(head))
            {
                if (head.Length == LongestHead)
                    throw new GatewayRefusalException(
                        "the gateway's answer has a head of more than " + LongestHead + " bytes");
                if (await stream.ReadAsync(one).ConfigureAwait(false) == 0)
                    throw new EndOfStreamException("the gateway closed the connection during the WebSocket request");
                head.Append((char)one[0]);
            }
            return head.ToString();
        }

        static bool EndsHead(StringBuilder head)
        {
            var n = head.Length;
            return n >= 4 && head[n - 4] == '\r' && head[n - 3] == '\n' && head[n - 2] == '\r' && head[n - 1] == '\n';
        }

        static void Check(string head, string key)
        {
            var lines = head.Split("\r\n", StringSplitOptions.RemoveEmptyEntries);
            var words = lines[0].Split(' ');
            if (words.Length < 2 || !words[0].StartsWith("HTTP/1.1", StringComparison.Ordinal)
                || !int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out var status))
                throw new GatewayRefusalException("the gateway's answer is not HTTP/1.1");
            if (status != 101) throw new GatewayRefusalException(RefusalOf(status));
            foreach (var line in lines)
                if (IsAcceptance(line, key)) return;
            throw new GatewayRefusalException("the answer does not accept this WebSocket request: is it a gateway?");
        }

        static bool IsAcceptance(string line, string key)
        {
            var colon = line.IndexOf(':');
            if (colon < 0 || !line.Substring(0, colon).Equals("Sec-WebSocket-Accept", StringComparison.OrdinalIgnoreCase)) return false;
#pragma warning disable CA5350 // RFC 6455 prescribes SHA-1; it proves nothing here but that the other side speaks WebSocket.
            using (var sha = SHA1.Create())
                return line.Substring(colon + 1).Trim() == Convert.ToBase64String(sha.ComputeHash(Encoding.ASCII.GetBytes(key + AcceptSalt)));
#pragma warning restore CA5350
        }
    }
}
