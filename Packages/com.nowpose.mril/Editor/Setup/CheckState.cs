namespace Nowpose.Editor.Setup
{
    /// <summary>How a project stands in one point.</summary>
    enum CheckState
    {
        /// <summary>As it should be.</summary>
        Good,

        /// <summary>Works as it is; the other way is better, or needed for something optional.</summary>
        Advice,

        /// <summary>Something will not work on the headset.</summary>
        Missing,

        /// <summary>Cannot be told from here.</summary>
        Unknown,
    }
}
