namespace Nowpose.Editor.Setup
{
    /// <summary>The state of a project in one check.</summary>
    enum CheckState
    {
        /// <summary>The project meets the requirement.</summary>
        Good,

        /// <summary>The project works as it is, but another setting is better, or needed for an optional feature.</summary>
        Advice,

        /// <summary>A part of the app does not work on the headset.</summary>
        Missing,

        /// <summary>The check cannot determine the state.</summary>
        Unknown,
    }
}
