namespace Nowpose.Editor.Setup
{
    /// <summary>Selects how a merge treats a manifest entry that does not meet the requirement.</summary>
    enum ConflictRule
    {
        /// <summary>Refuses the whole merge.</summary>
        Refuse,

        /// <summary>Keeps the entry.</summary>
        Keep,

        /// <summary>Replaces the entry.</summary>
        Replace,
    }
}
