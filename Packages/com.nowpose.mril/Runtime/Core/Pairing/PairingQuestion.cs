using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>A question to the wearer and its subject. Exactly one of the properties other than the text is set.</summary>
    sealed class PairingQuestion
    {
        PairingQuestion(string text) => Text = text;

        /// <summary>The question, in one line.</summary>
        public string Text { get; }

        /// <summary>Code of the gateway to accept; null if the question is about something else.</summary>
        public SeenCode Code { get; private set; }

        /// <summary>Name of the cell to forget; null if the question is about something else.</summary>
        public string Forgotten { get; private set; }

        /// <summary>Name of the known cell to use from now on; null if the question is about something else.</summary>
        public string Used { get; private set; }

        /// <param name="known">The accepted cell of the same name; null if there is none.</param>
        public static PairingQuestion Connect(SeenCode code, PairedCell known) =>
            new PairingQuestion(PairingMessages.Question(code.Cell, known?.Newest)) { Code = code };

        public static PairingQuestion Use(PairedCell cell, PairedCell instead) =>
            new PairingQuestion(PairingMessages.Use(cell.Cell, instead.Cell)) { Used = cell.Cell };

        public static PairingQuestion Forget(PairedCell cell) => new PairingQuestion(PairingMessages.Forget(cell.Newest)) { Forgotten = cell.Cell };
    }
}
