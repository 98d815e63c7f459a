using System;
using System.Globalization;
using System.Text;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>
    /// The code that the gateway shows for five minutes: a token that one headset may exchange for its own token, and the gateway's key.
    /// Secret.
    /// </summary>
    sealed class TokenCode
    {
        public const int Version = 1;

        /// <summary>Length of the token: 128 bits, which cannot be guessed.</summary>
        public const int TokenBytes = 16;

        internal const string Kind = "token";
        const string Keys = "ptx";
        const long LastUnixSeconds = 253402300799; // 9999-12-31, the maximum of DateTime

        static readonly DateTime UnixEpoch = new DateTime(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc);

        /// <param name="pin">The gateway's public key; null for a gateway without TLS, which must be on the headset's own machine.</param>
        /// <param name="token">Base64url of 16 bytes.</param>
        /// <param name="validToUtc">Expiry by the gateway's time of day; only a hint, because the headset's time may be wrong.</param>
        /// <exception cref="InputException">A value is invalid.</exception>
        public TokenCode(CertificatePin pin, string token, DateTime? validToUtc = null)
            : this(pin, token, validToUtc, null) { }

        TokenCode(CertificatePin pin, string token, DateTime? validToUtc, string text)
        {
            if (!Base64Url.TryRead(token ?? "", TokenBytes, out _))
                throw new InputException(PairingCodeMessages.TokenInvalid(TokenBytes));
            Pin = pin;
            Token = token;
            ValidToUtc = validToUtc;
            Text = text ?? Write();
        }

        /// <summary>The gateway's public key; null for a gateway without TLS.</summary>
        public CertificatePin Pin { get; }

        /// <summary>Token of the code. Never shown or logged.</summary>
        public string Token { get; }

        /// <summary>Expiry by the gateway's time of day; null if the code does not specify it.</summary>
        public DateTime? ValidToUtc { get; }

        /// <summary>The exact text of the code. Secret.</summary>
        public string Text { get; }

        /// <param name="text">String of any length; a string longer than <see cref="PairingCode.MaxLength"/> is rejected.</param>
        /// <exception cref="InputException">
        /// The text is not a token code of this version, or a value is invalid. The message is one line without the token.
        /// </exception>
        public static TokenCode Parse(string text)
        {
            var fields = new CodeFields(text, Kind, Version, Keys);
            var validTo = fields.Count('x', -1, 0, LastUnixSeconds);
            return new TokenCode(
                CellCode.PinOf(fields), fields.Text('t'), validTo < 0 ? (DateTime?)null : UnixEpoch.AddSeconds(validTo), text);
        }

        /// <summary>Returns whether the token belongs to the cell's gateway; it is sent only there.</summary>
        public bool IsFor(CellCode cell) => Equals(cell.Pin, Pin);

        /// <summary>Returns the kind of the code, without its content.</summary>
        public override string ToString() => "token code";

        string Write()
        {
            var text = new StringBuilder(PairingCode.Scheme).Append(Kind).Append('/').Append(Version).Append('?');
            if (Pin != null) text.Append("p=").Append(CellCode.TextOf(Pin)).Append('&');
            text.Append("t=").Append(Token);
            if (ValidToUtc is DateTime end)
                text.Append("&x=").Append(((long)(end - UnixEpoch).TotalSeconds).ToString(CultureInfo.InvariantCulture));
            return text.ToString();
        }
    }
}
