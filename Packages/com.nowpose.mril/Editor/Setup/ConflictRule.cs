namespace Nowpose.Editor
{
    /// <summary>What happens to an entry of a manifest that does not serve.</summary>
    enum ConflictRule
    {
        /// <summary>Nothing is changed, the others neither.</summary>
        Refuse,

        /// <summary>It stays as it is.</summary>
        Keep,

        /// <summary>What is needed takes its place.</summary>
        Replace,
    }
}
