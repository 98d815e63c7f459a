using System;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>Cancels waiting for tasks that cannot be cancelled themselves, such as a name lookup.</summary>
    static class TaskCancellation
    {
        /// <exception cref="OperationCanceledException">The wait was cancelled before the task completed; the task's result is ignored.</exception>
        public static async Task OrCancelled(this Task task, CancellationToken cancel)
        {
            var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
            using (cancel.Register(() => cancelled.TrySetResult(true)))
                await Task.WhenAny(task, cancelled.Task).ConfigureAwait(false);
            if (!task.IsCompleted)
            {
                // Reads the exception, so that a later failure is not reported as unobserved.
                _ = task.ContinueWith(late => late.Exception, CancellationToken.None, TaskContinuationOptions.OnlyOnFaulted, TaskScheduler.Default);
                throw new OperationCanceledException(cancel);
            }
            await task.ConfigureAwait(false);
        }

        /// <inheritdoc cref="OrCancelled(Task, CancellationToken)"/>
        public static async Task<T> OrCancelled<T>(this Task<T> task, CancellationToken cancel)
        {
            await OrCancelled((Task)task, cancel).ConfigureAwait(false);
            return await task.ConfigureAwait(false);
        }
    }
}
