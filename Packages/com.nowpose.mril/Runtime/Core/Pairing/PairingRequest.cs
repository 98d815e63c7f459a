using System;
using System.Globalization;
using System.IO;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Newtonsoft.Json;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>Exchanges a code's token for the headset's own token, with one HTTP/1.1 request over a stream that itself checks the pin.</summary>
    /// <remarks>Unity's HTTP clients do not check certificates reliably, so the token could be sent to any server.</remarks>
    static class PairingRequest
    {
        const int Nesting = 2;

        static readonly JsonNames AnswerFields = new JsonNames("token");

        /// <param name="gateway">Settings with a pin, or for this machine; their token is not used.</param>
        /// <param name="codeToken">Token of the gateway's code.</param>
        /// <returns>The response, which also reports failures.</returns>
        /// <exception cref="OperationCanceledException">The exchange was cancelled.</exception>
        /// <exception cref="InputException">The connection would go to another machine without encryption.</exception>
        public static async Task<PairingAnswer> SendAsync(ConnectionSettings gateway, string codeToken, CancellationToken cancel)
        {
            if (gateway.Security == TransportSecurity.Plain && !gateway.IsLoopback)
                throw new InputException(PairingAnswerMessages.Unencrypted(gateway.Host));
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(PairingLimits.ExchangeTimeout);
                try
                {
                    return await TalkAsync(gateway, codeToken, inTime.Token).OrCancelled(inTime.Token).ConfigureAwait(false);
                }
                catch (Exception failure)
                {
                    cancel.ThrowIfCancellationRequested();
                    var why = inTime.IsCancellationRequested
                        ? ConnectionMessages.NoResponse(PairingLimits.ExchangeTimeout.TotalSeconds)
                        : (failure is AggregateException ? failure.GetBaseException() : failure).Message;
                    return PairingAnswer.Failed(PairingAnswerMessages.Failed(gateway.Host, why));
                }
            }
        }

        static async Task<PairingAnswer> TalkAsync(ConnectionSettings gateway, string codeToken, CancellationToken cancel)
        {
            using (var stream = await new GatewayDialer(gateway).OpenAsync(gateway.WebSocketPort, cancel).ConfigureAwait(false))
            using (cancel.Register(stream.Dispose))
            {
                var request = Request(gateway, codeToken);
                await stream.WriteAsync(request, cancel).ConfigureAwait(false);
                await stream.FlushAsync(cancel).ConfigureAwait(false);
                var head = await HttpHead.ReadAsync(stream).ConfigureAwait(false);
                return head.Status == 200
                    ? await ReadAsync(stream, head, cancel).ConfigureAwait(false) : RefusalOf(head.Status);
            }
        }

        static byte[] Request(ConnectionSettings gateway, string codeToken)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture);
            using (var json = new JsonTextWriter(text) { StringEscapeHandling = StringEscapeHandling.EscapeNonAscii })
            {
                json.WriteStartObject();
                json.WritePropertyName("token");
                json.WriteValue(codeToken);
                json.WritePropertyName("name");
                json.WriteValue(gateway.HeadsetName);
                json.WriteEndObject();
            }
            var body = text.ToString();
            return Encoding.ASCII.GetBytes(
                "POST " + PairingLimits.Path + " HTTP/1.1\r\n"
                + "Host: " + gateway.WebSocketUri.Authority + "\r\n"
                + "Content-Type: application/json\r\n"
                + "Content-Length: " + body.Length.ToString(CultureInfo.InvariantCulture) + "\r\n"
                + "Connection: close\r\n\r\n" + body);
        }

        static PairingAnswer RefusalOf(int status)
        {
            switch (status)
            {
                case 401:
                    return PairingAnswer.Refused(PairingAnswerMessages.NotAccepted);
                case 404:
                case 426: return PairingAnswer.Refused(PairingAnswerMessages.NotStarted);
                case 429: return PairingAnswer.Failed(PairingAnswerMessages.TooManyWrong);
                case 503: return PairingAnswer.Failed(PairingAnswerMessages.NotSaved);
                default: return PairingAnswer.Refused(PairingAnswerMessages.Status(status.ToString(CultureInfo.InvariantCulture)));
            }
        }

        static async Task<PairingAnswer> ReadAsync(Stream stream, HttpHead head, CancellationToken cancel)
        {
            var isCounted = int.TryParse(head.Field("Content-Length"), NumberStyles.None, CultureInfo.InvariantCulture, out var length);
            if (!isCounted || length > PairingLimits.BodyBytes || head.Field("Transfer-Encoding") != null)
                return PairingAnswer.Refused(PairingAnswerMessages.TooLong(PairingLimits.BodyBytes));
            var body = new byte[length];
            for (var got = 0; got < length;)
            {
                var read = await stream.ReadAsync(body.AsMemory(got), cancel).ConfigureAwait(false);
                if (read == 0) throw new EndOfStreamException(ConnectionMessages.ClosedBeforeAnswer);
                got += read;
            }
            return TokenOf(body) is string token
                ? PairingAnswer.Accepted(token) : PairingAnswer.Refused(PairingAnswerMessages.NoToken);
        }

        static string TokenOf(byte[] utf8)
        {
            string token = null;
            var seen = 0;
            var json = new JsonUtf8Reader(utf8, Nesting);
            json.BeginObject();
            while (json.NextField(AnswerFields, ref seen, out _)) json.Text(out token);
            if (!json.EndObject(seen, 1) || !json.End()) return null;
            try
            {
                // Rejects a token that could not be sent.
                return new ConnectionSettings("127.0.0.1", token: token).Token;
            }
            catch (InputException)
            {
                return null;
            }
        }
    }
}
