namespace Nowpose.Prediction.Planning
{
    /// <summary>What a sample says of whether a joint follows its plan.</summary>
    enum PlanVerdict
    {
        /// <summary>Further off than the plan's uncertainty explains.</summary>
        NotFollowed,

        /// <summary>At rest any plan agrees that ends there.</summary>
        Unclear,

        Followed
    }
}
