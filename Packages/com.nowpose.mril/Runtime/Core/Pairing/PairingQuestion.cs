namespace Nowpose.Pairing
{
    /// <summary>What the wearer has to answer, and what agreeing to it is about: one of the other properties.</summary>
    sealed class PairingQuestion
    {
        PairingQuestion(string text) => Text = text;

        /// <summary>One line.</summary>
        public string Text { get; }

        /// <summary>Whose gateway is to be agreed to; null where something else is asked.</summary>
        public SeenCode Code { get; private set; }

        /// <summary>Name of the cell to forget; null where something else is asked.</summary>
        public string Forgotten { get; private set; }

        /// <summary>Name of the known cell to use from now on; null where something else is asked.</summary>
        public string Used { get; private set; }

        /// <param name="known">What was agreed to under that name before; null for nothing.</param>
        public static PairingQuestion Connect(SeenCode code, PairedCell known) =>
            new PairingQuestion(PairingWords.Question(code.Cell, known?.Newest)) { Code = code };

        public static PairingQuestion Use(PairedCell cell, PairedCell instead) =>
            new PairingQuestion(PairingWords.Use(cell.Cell, instead.Cell)) { Used = cell.Cell };

        public static PairingQuestion Forget(PairedCell cell) => new PairingQuestion(PairingWords.Forget(cell.Newest)) { Forgotten = cell.Cell };
    }
}
