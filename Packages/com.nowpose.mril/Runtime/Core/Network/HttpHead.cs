using System;
using System.Globalization;
using System.IO;
using System.Text;
using System.Threading.Tasks;
using Nowpose.Messages;

namespace Nowpose.Network
{
    /// <summary>Status and fields of an HTTP/1.1 response.</summary>
    sealed class HttpHead
    {
        const int MaxHeadBytes = 8 * 1024;

        readonly string[] _lines;

        HttpHead(int status, string[] lines) => (Status, _lines) = (status, lines);

        public int Status { get; }

        /// <summary>Reads up to and including the blank line, and no further, because WebSocket data may follow.</summary>
        /// <exception cref="GatewayRefusalException">The response is not HTTP/1.1, or too long.</exception>
        /// <exception cref="EndOfStreamException">The connection was closed before the blank line.</exception>
        public static async Task<HttpHead> ReadAsync(Stream stream)
        {
            var lines = (await TextAsync(stream).ConfigureAwait(false)).Split("\r\n", StringSplitOptions.RemoveEmptyEntries);
            var words = lines.Length > 0 ? lines[0].Split(' ') : Array.Empty<string>();
            if (words.Length < 2 || !words[0].StartsWith("HTTP/1.1", StringComparison.Ordinal)
                || !int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out var status))
                throw new GatewayRefusalException(ConnectionMessages.NotHttp);
            return new HttpHead(status, lines);
        }

        /// <summary>Returns the value of the first field of that name (ignoring case); null if there is none.</summary>
        public string Field(string name)
        {
            foreach (var line in _lines)
            {
                var colon = line.IndexOf(':');
                if (colon > 0 && line.Substring(0, colon).Equals(name, StringComparison.OrdinalIgnoreCase)) return line.Substring(colon + 1).Trim();
            }
            return null;
        }

        static async Task<string> TextAsync(Stream stream)
        {
            var head = new StringBuilder();
            var one = new byte[1];
            while (!IsEnded(head))
            {
                if (head.Length == MaxHeadBytes)
                    throw new GatewayRefusalException(ConnectionMessages.HeadTooLong(MaxHeadBytes));
                if (await stream.ReadAsync(one).ConfigureAwait(false) == 0)
                    throw new EndOfStreamException(ConnectionMessages.ClosedBeforeAnswer);
                head.Append((char)one[0]);
            }
            return head.ToString();
        }

        static bool IsEnded(StringBuilder head)
        {
            var n = head.Length;
            return n >= 4 && head[n - 4] == '\r' && head[n - 3] == '\n' && head[n - 2] == '\r' && head[n - 1] == '\n';
        }
    }
}
