namespace Nowpose.Pairing
{
    /// <summary>Result of an exchange: the headset's own token, or the reason why there is none.</summary>
    sealed class PairingAnswer
    {
        PairingAnswer(string token, string problem, bool isWorthRetrying) => (Token, Problem, IsWorthRetrying) = (token, problem, isWorthRetrying);

        /// <summary>The headset's own token; null if there is a problem. Secret.</summary>
        public string Token { get; }

        /// <summary>The problem in one line for the wearer; null if there is a token.</summary>
        public string Problem { get; }

        /// <summary>Whether the same code may be sent again, because the gateway has neither accepted nor rejected it.</summary>
        public bool IsWorthRetrying { get; }

        public static PairingAnswer Accepted(string token) => new PairingAnswer(token, null, false);
        public static PairingAnswer Refused(string problem) => new PairingAnswer(null, problem, false);
        public static PairingAnswer Failed(string problem) => new PairingAnswer(null, problem, true);
    }
}
